/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

A metric tensor for each point of the parameter domain. It decides which triangles count as well shaped: those
that are equilateral under it.

\cgalHasModel `CGAL::First_fundamental_form_metric_2<Kernel>`
\cgalHasModel `CGAL::Principal_curvature_metric_2<Kernel>`
*/
class ParametricSurfaceMetricField_2
{
public:
  /// the metric tensor where the surface has this jet. It must be finite. Where it is not positive
  /// definite the mesher replaces it and counts it in its report.
  CGAL::Metric_tensor_2 tensor(const CGAL::Surface_jet_3<Kernel>& jet) const;

  /// the squared length of the edge between two points. Symmetric. The criteria measure angles and
  /// sizes of triangles by the lengths of their edges.
  double squared_length(const CGAL::Parametric_point_2<Kernel>& p,
                        const CGAL::Parametric_point_2<Kernel>& q) const;
};
