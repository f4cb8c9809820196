/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

A surface in space given by a parametrisation `S : (u,v) -> R^3`, twice differentiable
wherever it is evaluated. Both functions must be deterministic. `jet()` is called for each point that the mesher
tries, and on the boundary more often; most calls of `point()` are made to test the deviation of edges.

The derivatives must be those of `point()`. The mesher compares them with differences of values in a few places of each patch,
and refuses a surface that contradicts itself with a `CGAL::Parametric_surface_mesh_error` that names the parameter values,
the derivative and what it ought to be. Creases, poles and rounding errors contradict nothing.

Surfaces are copied. An object is evaluated by one thread at a time: with threads, and without, each face that is meshed, and
each part of a large one, has a copy of its own, made when no other thread evaluates the original. So a surface may remember
what it has computed, as long as its copies do not share that. One whose copies share something that an evaluation changes
has a function `has_independent_copies()` that returns `false`; then faces with such surfaces are meshed one after the other.

A surface need not check its arguments. A value that is not finite is found by the
mesher and refused with a `CGAL::Parametric_surface_mesh_error` that names the parameter values.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Parametric_function_surface_3<Function\,Kernel>}
\cgalHasModels{CGAL::Parametric_plane_3<Kernel>}
\cgalHasModels{CGAL::Parametric_cylinder_3<Kernel>}
\cgalHasModels{CGAL::Parametric_cone_3<Kernel>}
\cgalHasModels{CGAL::Parametric_sphere_3<Kernel>}
\cgalHasModels{CGAL::Parametric_torus_3<Kernel>}
\cgalHasModels{CGAL::Bezier_surface_3<Kernel>}
\cgalHasModels{CGAL::B_spline_surface_3<Kernel>}
\cgalHasModels{CGAL::Open_cascade_surface_3}
\cgalHasModels{CGAL::Any_parametric_surface_3<Kernel>}
\cgalHasModelsEnd
*/
class ParametricSurface_3
{
public:
  /// the kernel of the points and vectors: a model of `Kernel` with `double` as number type.
  typedef unspecified_type Geom_traits;

  /// tells whether the surface and its copies can be evaluated by several threads at the same time, each object by one of
  /// them. This function is optional; surfaces without it are taken to have independent copies.
  bool has_independent_copies() const;

  /// `S(u,v)`
  Geom_traits::Point_3 point(double u, double v) const;

  /// `S(u,v)` with all partial derivatives up to second order.
  CGAL::Surface_jet_3<Geom_traits> jet(double u, double v) const;

  /// optional: lines of the domain, by their `u` and by their `v`, in ascending order, such that no feature of the surface is
  /// narrower than they are apart. They are where the mesher looks for features that its triangles miss. If both are empty
  /// the surface has no features and is not looked at. Without this function the mesher uses even lines; see
  /// `CGAL::Parametric_surface_mesh_criteria::set_feature_resolution()`.
  std::array<std::vector<double>, 2> feature_lines() const;
};
