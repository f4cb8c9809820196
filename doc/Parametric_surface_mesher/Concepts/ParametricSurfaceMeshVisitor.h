/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

Shows the progress of meshing, and can stop it.

\cgalHasModel `CGAL::Parametric_surface_mesh_visitor`
*/
class ParametricSurfaceMeshVisitor
{
public:
  /// called when a phase begins: `"division"`, `"triangulation"`, `"refinement"`, `"smoothing"`, `"improvement"`,
  /// `"polishing"`, `"output"`. With smoothing there is refinement before and after it; only some patches are polished. For a
  /// model of several patches, the phases from triangulation to polishing alternate, patch by patch.
  void on_phase(const char* name);

  /// called during refinement, once for some hundred new vertices.
  /// \param number_of_vertices the vertices so far
  /// \param number_of_bad_faces an upper bound of the number of triangles still waiting
  void on_progress(std::size_t number_of_vertices, std::size_t number_of_bad_faces);

  /// asked as often as `on_progress()` is called; `false` ends the refinement with the valid mesh of that moment.
  bool go_further();
};
