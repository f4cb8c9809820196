/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

What a mesh must meet: a model of `MeshingCriteria_2` but for the argument of `is_bad_object()`, which gives the test access
to the patch. The usual way to a model of one's own is to derive from `CGAL::Parametric_surface_mesh_criteria` and its
`Is_bad`.

\cgalHasModel `CGAL::Parametric_surface_mesh_criteria`
*/
class ParametricSurfaceMeshCriteria_2
{
public:
  /// how bad a triangle is. It has the members `double badness` (above 1 for a bad triangle, larger is worse),
  /// `CGAL::Mesh_criterion criterion` and `bool is_well_shaped` of `CGAL::Parametric_surface_mesh_criteria::Quality`.
  typedef unspecified_type Quality;

  /*!
  the test of one patch: a function object with a type `Quality` and the two functions
  - `CGAL::Mesh_2::Face_badness operator()(Face_handle f, Quality& q) const` evaluates the triangle `f`;
  - `CGAL::Mesh_2::Face_badness operator()(const Quality& q) const` tells from the quality alone.

  Triangles that are `IMPERATIVELY_BAD` are refined before those that are `BAD`, and well-shaped ones last. Of a face
  handle it may use `f->vertex(i)->point()`, a `CGAL::Parametric_point_2`, `f->vertex(i)->spacing()`, and
  `f->is_constrained(i)`, which tells whether the edge opposite to vertex `i` is on the boundary.
  */
  template <class Oracle>
  class Is_bad;

  /// the test for the triangles of a patch, given by a `CGAL::Parametric_surface_oracle_3`.
  template <class Oracle>
  Is_bad<Oracle> is_bad_object(const Oracle& oracle) const;

  /// \name Sizes
  /// As in `CGAL::Parametric_surface_mesh_criteria`, from which a model derives.
  /// @{
  double max_edge() const;
  double min_edge() const;
  double gamma() const;
  double distance() const;
  std::size_t max_number_of_vertices() const;
  /// @}
};
