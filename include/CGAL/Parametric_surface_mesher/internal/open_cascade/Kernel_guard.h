// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_KERNEL_GUARD_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_KERNEL_GUARD_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <Standard_Failure.hxx>

#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

inline std::string describe_failure(const Standard_Failure& failure)
{
  const char* message = failure.GetMessageString();
  return std::string("Open CASCADE: ") + failure.DynamicType()->Name()
         + (message != nullptr && *message != '\0' ? std::string(", ") + message : "");
}

// Calls `function`. Exceptions of Open CASCADE, which are not derived from `std::exception`, become those of this package.
template <class Function>
auto guarded(Function function)
{
  try {
    return function();
  }
  catch(const Standard_Failure& failure) {
    throw Parametric_surface_mesh_error(describe_failure(failure));
  }
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_KERNEL_GUARD_H
