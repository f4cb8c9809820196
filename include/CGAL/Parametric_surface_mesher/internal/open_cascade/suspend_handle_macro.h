// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Open CASCADE defines a macro `Handle`, which is a name in CGAL. Headers of CGAL that come after one of Open CASCADE are
// included between this file and restore_handle_macro.h. (No include guard: the two come in pairs.)
#pragma push_macro("Handle")
#undef Handle
