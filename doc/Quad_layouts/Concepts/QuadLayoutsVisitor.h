/*!
\ingroup PkgQuadLayoutsConcepts
\cgalConcept

describes what the functions of this package tell while they work, and how they can be stopped. A
visitor is passed by the named parameter `visitor`: by value, or as `std::ref(visitor)`.

A stage has the name of its function, such as `compute_cross_field`.

\cgalHasModel `CGAL::Quad_layouts::Default_visitor`
*/
class QuadLayoutsVisitor
{
public:
  /// is called before the stage called `name`.
  void before_stage(const char* name);

  /// is called after the stage called `name`, which took `seconds`. It is not called when the stage
  /// ends with an exception.
  void after_stage(const char* name, double seconds);

  /// is called now and then, when `fraction` (0 to 1) of the stage called `name` is done.
  void progress(const char* name, double fraction);

  /// is called when the integer program has a better solution or a better bound, `seconds` after
  /// its start.
  void improved(double objective, double bound, double seconds);

  /// is called when there is a `reason`, which ended a stage or spoiled its result, to go on by
  /// another `CGAL::Quad_layouts::Layout_route` than the one asked for.
  void changed_route(const char* reason);

  /// is called often, and says whether the work shall go on. If it does not, it is not called again,
  /// and the function that works ends with the exception `CGAL::Quad_layouts::Cancelled`, and has no
  /// effect.
  bool go_on();
};
