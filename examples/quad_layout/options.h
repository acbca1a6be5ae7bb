// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_EXAMPLES_OPTIONS_H
#define QUAD_LAYOUTS_EXAMPLES_OPTIONS_H

#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

// says what is wrong with the command line
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// what the command line asks for
struct Options
{
  std::string input;
  std::string output = ".";
  std::string field; // a file, or empty; so are these:
  std::string parametrization;
  std::string written_field;
  std::string program;                    // to write
  std::string solution;                   // to read
  std::string solver = "glpk";            // or "cbc" or "highs"
  std::string field_method = "diffusion"; // or "mixed-integer"
  std::string route = "automatic";        // or "field" or "parametrization"
  double alpha = 15;                      // degrees
  double displacement = 2;                // target edge lengths
  double edge_length = 0.01;              // of the diagonal of the bounding box
  double time_limit = std::numeric_limits<double>::infinity(); // seconds
  double search_limit = 30;                                    // seconds
  double features = 0;                                         // degrees; 0: none
  int min_valence = 3;
  int max_valence = 8;
  int threads = 1;
  bool repair = false;
  bool quiet = false;
  bool help = false;
};

inline const char* usage()
{
  return "usage: quad_layout INPUT [--output DIR] [--alpha DEG] [--displacement R]\n"
         "                         [--edge-length FRACTION] [--min-valence N] [--max-valence N]\n"
         "                         [--solver NAME] [--threads N] [--search-limit S]\n"
         "                         [--time-limit S]\n"
         "                         [--field FILE] [--field-method NAME] [--write-field FILE]\n"
         "                         [--parametrization FILE] [--route NAME] [--features DEG]\n"
         "                         [--repair]\n"
         "                         [--write-program FILE] [--read-solution FILE] [--quiet]\n"
         "\n"
         "Computes a simple quad layout of a triangle mesh, and a quad mesh on it.\n"
         "INPUT is an OFF, OBJ, PLY or STL file, told by its extension.\n"
         "\n"
         "  --output DIR           where the results go, made if needed (.)\n"
         "  --alpha DEG            how far layout edges may turn away from the field (15)\n"
         "  --displacement R       how far singularities may move, in edge lengths (2)\n"
         "  --edge-length FRACTION of the quads, by the bounding box's diagonal (0.01)\n"
         "  --min-valence N        least valence of a vertex (3)\n"
         "  --max-valence N        greatest valence of a vertex (8)\n"
         "  --solver NAME          of the integer program: glpk, cbc or highs (glpk)\n"
         "  --threads N            how many searches of the integer program run at a time (1)\n"
         "  --search-limit S       for better solutions of the program than the first, in seconds "
         "(30)\n"
         "  --time-limit S         for everything, in seconds; the integer program gets at most "
         "half\n"
         "                         of what is left when it begins (none)\n"
         "  --field FILE           a cross field: .rosy, .rawfield or .ffield, or else a line \"x "
         "y z\"\n"
         "                         for each face\n"
         "  --field-method NAME    of smooth fields: diffusion or mixed-integer (diffusion)\n"
         "  --parametrization FILE a seamless parametrization, given by the texture coordinates of "
         "an\n"
         "                         OBJ file of INPUT, to use in place of a field\n"
         "  --route NAME           what layout lines follow: field, or parametrization, which is a "
         "seamless\n"
         "                         one of the field if one is found, or automatic, which is the "
         "field for\n"
         "                         more than 100,000 triangles or 1,000 singularities, or if quads "
         "are\n"
         "                         inverted by the other route (automatic)\n"
         "  --write-field FILE     where to write the field, as .rosy, .rawfield or .ffield\n"
         "  --features DEG         keep edges that are sharper than this angle (none)\n"
         "  --repair               first make an oriented manifold of triangles of the input\n"
         "  --write-program FILE   where to write the integer program, in MPS format\n"
         "  --read-solution FILE   a solution of that program, used instead of solving it\n"
         "  --quiet                no progress on the standard error stream\n"
         "\n"
         "Results: layout.obj, layout_curves.obj, quad_mesh.obj, quad_mesh.vtp, stats.json.\n"
         "Exit status: 0 done, 1 refused or failed, 2 wrong usage.\n";
}

// reads all of a text as a number
template <class Number>
Number number(const std::string& option, const std::string& text)
{
  std::size_t used = 0;
  Number value = 0;
  try {
    if constexpr (std::is_integral_v<Number>)
      value = std::stoi(text, &used);
    else
      value = std::stod(text, &used);
  } catch (const std::logic_error&) {
    used = 0;
  }
  if (text.empty() || used != text.size())
    throw Usage_error(option + " needs a number, not \"" + text + "\"");
  return value;
}

inline void check_solver(const std::string& name)
{
  // what is built into this program, and what others come from
  std::map<std::string, bool> is_there = {{"glpk", true}, {"cbc", false}, {"highs", false}};
  const std::map<std::string, std::string> package = {{"cbc", "CBC (coinor-libcbc-dev)"},
                                                      {"highs", "HiGHS (libhighs-dev)"}};
#ifdef CGAL_USE_CBC
  is_there["cbc"] = true;
#endif
#ifdef CGAL_USE_HIGHS
  is_there["highs"] = true;
#endif
  if (is_there.count(name) == 0)
    throw Usage_error("unknown solver " + name + ": there are glpk, cbc and highs");
  if (!is_there[name])
    throw Usage_error("the solver " + name + " is not built into this program: build it where " +
                      package.at(name) + " is installed");
}

inline Options parse(int argc, char* argv[])
{
  Options result;
  using Setter = std::function<void(const std::string& option, const std::string& value)>;
  const auto real = [](double& x) -> Setter {
    return [&x](const std::string& o, const std::string& v) { x = number<double>(o, v); };
  };
  const auto integer = [](int& x) -> Setter {
    return [&x](const std::string& o, const std::string& v) { x = number<int>(o, v); };
  };
  const auto text = [](std::string& x) -> Setter {
    return [&x](const std::string&, const std::string& v) { x = v; };
  };
  const std::map<std::string, Setter> setters = {
      {"--output", text(result.output)},
      {"--alpha", real(result.alpha)},
      {"--displacement", real(result.displacement)},
      {"--edge-length", real(result.edge_length)},
      {"--min-valence", integer(result.min_valence)},
      {"--max-valence", integer(result.max_valence)},
      {"--solver", text(result.solver)},
      {"--threads", integer(result.threads)},
      {"--search-limit", real(result.search_limit)},
      {"--time-limit", real(result.time_limit)},
      {"--field", text(result.field)},
      {"--parametrization", text(result.parametrization)},
      {"--field-method", text(result.field_method)},
      {"--route", text(result.route)},
      {"--write-field", text(result.written_field)},
      {"--features", real(result.features)},
      {"--write-program", text(result.program)},
      {"--read-solution", text(result.solution)},
  };
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto setter = setters.find(word);
    if (setter != setters.end()) {
      if (++i == argc)
        throw Usage_error(word + " needs a value");
      setter->second(word, argv[i]);
    } else if (word == "--repair")
      result.repair = true;
    else if (word == "--quiet")
      result.quiet = true;
    else if (word == "--help" || word == "-h")
      result.help = true;
    else if (word.size() > 1 && word[0] == '-')
      throw Usage_error("unknown option " + word);
    else if (!result.input.empty())
      throw Usage_error("more than one input: " + result.input + " and " + word);
    else
      result.input = word;
  }
  if (result.input.empty() && !result.help)
    throw Usage_error("no input");
  check_solver(result.solver);
  if (!(result.time_limit > 0) || !(result.search_limit > 0))
    throw Usage_error("a time limit must be greater than 0");
  if (result.field_method != "diffusion" && result.field_method != "mixed-integer")
    throw Usage_error("unknown field method " + result.field_method +
                      ": there are diffusion and mixed-integer");
  if (result.route != "field" && result.route != "parametrization" && result.route != "automatic")
    throw Usage_error("unknown route " + result.route +
                      ": there are field, parametrization and automatic");
  if (!result.field.empty() && !result.parametrization.empty())
    throw Usage_error("--field and --parametrization exclude each other");
  if (!(result.features >= 0) || result.features > 180)
    throw Usage_error("--features needs an angle from 0 to 180 degrees");
  return result;
}

#endif // QUAD_LAYOUTS_EXAMPLES_OPTIONS_H
