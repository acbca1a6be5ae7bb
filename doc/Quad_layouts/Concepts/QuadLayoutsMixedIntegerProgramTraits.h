/*!
\ingroup PkgQuadLayoutsConcepts
\cgalConcept

describes a solver of mixed integer programs that knows limits and tells how far it came. It is the
first template parameter of `CGAL::Quad_layouts::quantize()`.

\cgalRefines{MixedIntegerProgramTraits}

\cgalHasModel `CGAL::Quad_layouts::GLPK_mixed_integer_program_traits<FT>`
\cgalHasModel `CGAL::Quad_layouts::CBC_mixed_integer_program_traits<FT>`
\cgalHasModel `CGAL::Quad_layouts::HiGHS_mixed_integer_program_traits<FT>`
\cgalHasModel `CGAL::Quad_layouts::Mixed_integer_program_traits_adaptor<PlainTraits>`

The example own_solver.cpp has a small model.
*/
class QuadLayoutsMixedIntegerProgramTraits
{
public:
  /// \name Types
  /// @{

  /// has the enumerators `OPTIMAL`, `FEASIBLE` (there is a solution, but a limit ended the search),
  /// `INFEASIBLE`, `UNKNOWN` (a limit ended the search before a solution was found) and `FAILED`.
  typedef unspecified_type Status;

  /// @}
  /// \name Limits
  /// They hold for the next call of `solve()`.
  /// @{

  /// bounds the time of a search.
  void set_time_limit(double seconds);

  /// bounds the work of a search, by a number that does not depend on the machine.
  void set_node_limit(int nodes);

  /// ends the search when the relative distance of solution and bound is at most `gap`.
  void set_relative_gap(double gap);

  /// sets what is asked now and then if the search is to end.
  void set_interrupt(std::function<bool()> stop);

  /// @}
  /// \name Operations
  /// @{

  /// gives a feasible solution to begin with, a value per variable.
  void set_start_solution(std::vector<FT> values);

  /// returns how the last call of `solve()` ended.
  Status status() const;

  /// returns the objective of the solution that was found.
  FT objective_value() const;

  /// returns a value that no solution is better than.
  FT best_bound() const;

  /// @}
};
