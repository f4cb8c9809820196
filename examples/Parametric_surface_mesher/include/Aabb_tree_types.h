// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The classes of AABB trees of triangles in space, which have other names from CGAL 6 on.
#ifndef AABB_TREE_TYPES_H
#define AABB_TREE_TYPES_H

#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#if __has_include(<CGAL/AABB_traits_3.h>)
template <class Kernel, class Primitive>
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;

template <class Kernel, class Iterator>
using Aabb_triangle_primitive = CGAL::AABB_triangle_primitive_3<Kernel, Iterator>;
#else
template <class Kernel, class Primitive>
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

template <class Kernel, class Iterator>
using Aabb_triangle_primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
#endif

#endif // AABB_TREE_TYPES_H
