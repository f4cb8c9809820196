/*!
\ingroup PkgParametricSurfaceMesherConcepts
\cgalConcept

Wanted edge lengths at points in space: a function object, a generic lambda expression for example. It is given to a model by
`CGAL::Parametric_surface_model_3::set_sizing_field()`. Curvature, the maximum edge length and what is near may ask for shorter edges.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Graded_sizing_field_3<Kernel>}
\cgalHasModels{CGAL::Interpolated_sizing_field_3<Kernel>}
\cgalHasModels{CGAL::Least_sizing_field_3<Point_3>}
\cgalHasModelsEnd
*/
class ParametricSurfaceSizingField_3
{
public:
  /*!
  returns the wanted edge length at a point: a positive number, or infinity where none is wanted.

  It is called often, by several threads at a time where there are, and must depend on the point alone. Lengths of points at a distance d
  from each other should not differ by more than about 0.3 d: triangles whose edges grow faster are not well shaped.

  \tparam Point_3 the type of points of the surfaces
  */
  template <class Point_3>
  double operator()(const Point_3& p) const;
};
