/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

A metric tensor for each point of the parameter domain. It decides which triangles count as well shaped: those
that are equilateral under it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::First_fundamental_form_metric_2<Kernel>}
\cgalHasModels{CGAL::Principal_curvature_metric_2<Kernel>}
\cgalHasModelsEnd
*/
class ParametricSurfaceMetricField_2
{
public:
  /*!
  the metric tensor at a point where the surface has this jet, in the coordinates by which the jet is differentiated. These
  are usually the parameters of the surface; close to a pole they are those of a chart, and where the parametrisation is nearly
  singular, first derivatives are replaced by slopes of chords. Therefore the tensor must be computed from the jet.

  Its components must be finite and below `1e150`; otherwise the mesher throws a `CGAL::Parametric_surface_mesh_error` that
  names the parameters `(u,v)`. If the tensor is not positive definite, or the ratio of its eigenvalues is below `1e-14`, the
  mesher replaces the eigenvalues by their absolute values, but at least by a millionth of the larger one, and keeps the
  eigenvectors; a tensor that is zero becomes a small multiple of the identity. These points are counted in
  `CGAL::Parametric_surface_mesh_report::number_of_replaced_tensors`.
  */
  CGAL::Metric_tensor_2 tensor(const CGAL::Surface_jet_3<Kernel>& jet) const;

  /// optional; called instead of the function above if it exists: the tensor of a field that also depends on the parameters
  /// `(u,v)` of the surface.
  CGAL::Metric_tensor_2 tensor(const CGAL::Surface_jet_3<Kernel>& jet, double u, double v) const;

  /// the squared length of the edge between two points. Symmetric. The criteria measure angles and
  /// sizes of triangles by the lengths of their edges. A length that is negative or not finite is refused with a
  /// `CGAL::Parametric_surface_mesh_error` that names the two points in space.
  double squared_length(const CGAL::Parametric_point_2<Kernel>& p,
                        const CGAL::Parametric_point_2<Kernel>& q) const;
};
