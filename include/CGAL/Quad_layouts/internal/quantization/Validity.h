// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_VALIDITY_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_VALIDITY_H

#include <CGAL/Quad_layouts/internal/layout/quotient.h>
#include <CGAL/Quad_layouts/internal/quantization/evaluate_program.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Examines layouts for what the rows of the program do not see, and turns it into cuts: loops of
// length 0 that change the topology, and clusters of more singularities than pairs can see, whose
// index is out of range, or that are not to be where no pair may merge, or that the user forbids.
class Validity
{
public:
  Validity(const T_mesh& t_mesh, const Quantization_program& paper, Reduced_program& program)
    : m_t_mesh(t_mesh), m_paper(paper), m_program(program)
  {
    for (std::size_t k = 0; k < program.indicators.size(); ++k) {
      m_indicators[program.indicators[k].i].push_back(int(k));
      m_indicators[program.indicators[k].j].push_back(int(k));
    }
  }

  // says if the layout of `x` is valid; if not, adds cuts that `x` violates to the program
  bool examine(const std::vector<int>& x)
  {
    const Quotient_report report = examine_quotient(m_t_mesh, m_program.arc_lengths(x));
    bool valid = report.valid;
    for (const Quotient_cut& cut : report.cuts)
      add({m_program.set_of(cut.arcs), {}, cut.is_exact});
    for (const Merged_cluster& cluster : report.clusters)
      if (!is_legal(cluster) && (add(cut_of(cluster)) || has_valence_below_two(cluster)))
        valid = false;
    for (const Close_pair& pair : m_paper.separate)
      if (are_merged(report, pair.i, pair.j)) {
        separate(pair, x);
        valid = false;
      }
    return valid;
  }

private:
  bool is_legal(const Merged_cluster& cluster) const
  {
    const auto singularities = std::count_if(cluster.nodes.begin(), cluster.nodes.end(),
                                             [&](int n) { return m_t_mesh.index(n) != 0; });
    return excess(cluster) == 0 && (singularities < 2 || !m_paper.pairs.empty());
  }

  // says if no mesh of quadrilaterals has the vertex of a cluster
  bool has_valence_below_two(const Merged_cluster& cluster) const
  {
    const bool is_on_border = std::any_of(cluster.nodes.begin(), cluster.nodes.end(),
                                          [&](int n) { return m_t_mesh.is_on_border(n); });
    return cluster.index > (is_on_border ? 1 : 2);
  }

  // how far the index of a cluster is outside the range of its members
  int excess(const Merged_cluster& cluster) const
  {
    int low = 0, high = 0;
    for (int n : cluster.nodes) {
      low = (std::min)(low, m_paper.index_range[n].first);
      high = (std::max)(high, m_paper.index_range[n].second);
    }
    return internal::excess(cluster.index, low, high);
  }

  // Some arc that holds the cluster together becomes positive, or a singularity of the index that
  // is missing joins it. To forbid the cluster as such would forbid legal larger ones. Legal ones
  // can still be forbidden if they are joined in a way that no indicator sees.
  Reduced_program::Cut cut_of(const Merged_cluster& cluster) const
  {
    Reduced_program::Cut cut{m_program.set_of(cluster.tree_arcs),
                             {},
                             cluster.is_joined_by_arcs && m_paper.pairs.empty()};
    const int sign = excess(cluster) > 0 ? -1 : 1;
    for (int n : cluster.nodes) {
      const auto found = m_indicators.find(n);
      if (found == m_indicators.end())
        continue;
      for (int k : found->second) {
        const auto& indicator = m_program.indicators[k];
        const int other = indicator.i == n ? indicator.j : indicator.i;
        if (!std::binary_search(cluster.nodes.begin(), cluster.nodes.end(), other) &&
            m_t_mesh.index(other) * sign > 0)
          cut.indicators.push_back(k);
      }
    }
    std::sort(cut.indicators.begin(), cut.indicators.end());
    cut.indicators.erase(std::unique(cut.indicators.begin(), cut.indicators.end()),
                         cut.indicators.end());
    return cut;
  }

  // asks for a positive arc between nodes that the user wants to be separate
  void separate(const Close_pair& pair, const std::vector<int>& x)
  {
    const Quotient_cut cut = cut_between(m_t_mesh, m_program.arc_lengths(x), pair.i, pair.j);
    if (!add({m_program.set_of(cut.arcs), {}, cut.is_exact}) && cut.is_exact)
      throw inseparable(m_t_mesh, pair.i, pair.j);
  }

  // returns false if the cut asks for what no consistent quantization has
  bool add(Reduced_program::Cut cut)
  {
    if (cut.variables.empty())
      return false;
    m_program.cuts.push_back(std::move(cut));
    return true;
  }

  const T_mesh& m_t_mesh;
  const Quantization_program& m_paper;
  Reduced_program& m_program;
  std::map<int, std::vector<int>> m_indicators; // per node
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_VALIDITY_H
