// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// It has the form of the files of the same kind that CGAL generates for its packages.

#ifndef CGAL_LICENSE_PARAMETRIC_SURFACE_MESHER_H
#define CGAL_LICENSE_PARAMETRIC_SURFACE_MESHER_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_COMMERCIAL_LICENSE

#  if CGAL_PARAMETRIC_SURFACE_MESHER_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#    if defined(CGAL_LICENSE_WARNING)

       CGAL_pragma_warning("Your commercial license for CGAL does not cover "
                           "this release of the Parametric Surface Mesher package.")
#    endif

#    ifdef CGAL_LICENSE_ERROR
#      error "Your commercial license for CGAL does not cover this release \
              of the Parametric Surface Mesher package. \
              You get this error, as you defined CGAL_LICENSE_ERROR."
#    endif // CGAL_LICENSE_ERROR

#  endif // CGAL_PARAMETRIC_SURFACE_MESHER_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#else // no CGAL_PARAMETRIC_SURFACE_MESHER_COMMERCIAL_LICENSE

#  if defined(CGAL_LICENSE_WARNING)
     CGAL_pragma_warning("\nThe macro CGAL_PARAMETRIC_SURFACE_MESHER_COMMERCIAL_LICENSE is not defined."
                          "\nYou use the CGAL Parametric Surface Mesher package under "
                          "the terms of the GPLv3+.")
#  endif // CGAL_LICENSE_WARNING

#  ifdef CGAL_LICENSE_ERROR
#    error "The macro CGAL_PARAMETRIC_SURFACE_MESHER_COMMERCIAL_LICENSE is not defined.\
            You use the CGAL Parametric Surface Mesher package under the terms of \
            the GPLv3+. You get this error, as you defined CGAL_LICENSE_ERROR."
#  endif // CGAL_LICENSE_ERROR

#endif // no CGAL_PARAMETRIC_SURFACE_MESHER_COMMERCIAL_LICENSE

#endif // CGAL_LICENSE_PARAMETRIC_SURFACE_MESHER_H
