/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

A criterion of the user that triangles are to meet, beside those of `CGAL::Parametric_surface_mesh_criteria`: a function
object, a generic lambda expression for example. It is passed by `CGAL::parameters::triangle_criterion()`. What fails it in the
end is in the report as `CGAL::Parametric_surface_mesher::Mesh_criterion::USER`.

\cgalRefines{CopyConstructible}
*/
class ParametricSurfaceTriangleCriterion
{
public:
  /*!
  returns by how much a triangle misses the criterion: it fails if the value is above 1, and triangles with larger values are
  refined first. A squared ratio of lengths, of what the triangle has to what it may have, fits the values that the mesher has
  for the size; only the order matters.

  It is called often, by several threads at a time where there are, and must depend on the triangle alone.

  \tparam Triangle a `CGAL::Parametric_surface_mesher::Triangle_view`
  */
  template <class Triangle>
  double operator()(const Triangle& triangle) const;
};
