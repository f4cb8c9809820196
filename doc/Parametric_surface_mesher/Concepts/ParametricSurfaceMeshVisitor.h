/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

Shows the progress of meshing, and can stop it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Parametric_surface_mesh_visitor}
\cgalHasModelsEnd
*/
class ParametricSurfaceMeshVisitor
{
public:
  /// called when a phase begins: `"division"` of the edges, `"triangulation"` of the boundary of a patch, `"refinement"`,
  /// `"smoothing"`, `"improvement"`, `"polishing"`, `"curing"` of the whole mesh, `"intersections"`, `"output"`. With smoothing there is
  /// refinement before and after it, and some patches are refined and improved once more; only some are polished. Division and output come
  /// once, curing only if detail may vanish, and intersections only if they are looked for; where some are found, a model may be meshed
  /// again, from its division on. For a model of several patches, or for parts of a large patch, the phases from triangulation to
  /// polishing alternate.
  void on_phase(const char* name);

  /// called when a face of a model begins. A visitor need not have this function. With threads several faces are at work at the same time;
  /// if a model is meshed again, its faces are counted from 1 again, with those that keep their triangles.
  /// \param number how many faces have begun, with this one
  /// \param number_of_faces how many there are
  void on_face(std::size_t number, std::size_t number_of_faces);

  /// called during refinement, once for some hundred new vertices. A patch that may be split is first refined as a coarse
  /// sketch, which has its own vertices.
  /// \param number_of_vertices the vertices of the patch, or part of one, so far
  /// \param number_of_bad_faces an upper bound of the number of its triangles still waiting
  void on_progress(std::size_t number_of_vertices, std::size_t number_of_bad_faces);

  /// asked whether meshing is to go on: after each call of `on_phase()` and `on_progress()`, and in all phases but the output
  /// every two milliseconds, whatever the number of patches and threads; less often where one evaluation of a surface, or
  /// looking for crossings of the boundary of one patch, takes longer.
  ///
  /// `false` stops the run, and the function is not asked again. The mesh is that of the moment: patches that are done stay,
  /// one at work stays as it is, and of all others only the boundary is triangulated, with coarse edges if the division was not
  /// done. So the mesh is valid, and closed where the model is. The report tells of the stop, and lists the triangles that
  /// fail a criterion because of it.
  bool go_further();
};
