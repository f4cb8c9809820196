/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

A curve in space that can be divided.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Parametric_surface_mesher::Curve_on_surface_3<Surface>}
\cgalHasModelsEnd
*/
class ParametricCurve_3
{
public:
  /// the kernel of its points.
  typedef unspecified_type Geom_traits;

  /// the parameters of both ends; `end() < begin()` is allowed.
  double begin() const;
  double end() const;

  /// the point at `t`.
  Geom_traits::Point_3 point(double t) const;

  /// the length of the derivative by `t`.
  double speed(double t) const;

  /// the curvature radius at `t`; infinite where the curve is straight.
  double curvature_radius(double t) const;
};
