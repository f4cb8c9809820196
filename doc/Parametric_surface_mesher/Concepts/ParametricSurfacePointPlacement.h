/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

Where a point is put for a triangle that fails the criteria: a function object, a lambda expression for example. It is passed by
`CGAL::Parametric_surface_mesh_criteria::set_placement()`. The place is given in the triangle, by the lengths of its sides in space, and needs
no knowledge of the surface. What is too close to another vertex, or beyond the boundary, is not accepted; then the mesher tries places of its own.

\cgalRefines{CopyConstructible}
\cgalHasModelsBegin
\cgalHasModels{CGAL::Parametric_surface_mesher::Circumcenter_placement}
\cgalHasModels{CGAL::Parametric_surface_mesher::Off_center_placement}
\cgalHasModelsEnd

The third placement, `FRONTAL` of `CGAL::Parametric_surface_mesher::Mesh_point_placement`, goes through the patch from the boundary inwards; it takes
circumcentres for what is left.
*/
class ParametricSurfacePointPlacement
{
public:
  /*!
  returns the barycentric coordinates of the new point in the triangle, by corner. Their sum is 1; outside of the triangle some are negative.

  It is called often, by several threads at a time where there are, and must depend on its arguments alone.

  \param squared_lengths the squares of the lengths of the sides, each one opposite to the corner with its number
  \param spacing the wanted edge length there
  */
  std::array<double, 3> operator()(const std::array<double, 3>& squared_lengths, double spacing) const;
};
