// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_EXAMPLES_FILE_HEADER_H
#define QUAD_LAYOUTS_EXAMPLES_FILE_HEADER_H

#include "polygon_soup.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>

// Looks at the header of a file before CGAL's readers do, which believe it: they get memory for as
// many elements as it announces, a PLY property belongs to the element before it, and has the type
// that they want it to have.
class File_header
{
public:
  explicit File_header(const std::string& file)
    : m_in(file, std::ios::binary), m_size(std::filesystem::file_size(file))
  {
  }

  void check_off()
  {
    std::string word;
    next_word(word);
    if (word.find("OFF") == std::string::npos)
      throw Input_error("does not begin with OFF");
    next_word(word);
    if (word == "BINARY")
      throw Input_error("binary OFF is not supported");
    check_count("vertices", word);
    next_word(word);
    check_count("faces", word);
  }

  void check_ply()
  {
    std::string element;
    Ply_types types; // of the properties of this element
    for (std::string line; std::getline(m_in, line);) {
      std::istringstream words(line);
      std::string keyword, name, count;
      words >> keyword;
      if (keyword == "element") {
        check_ply_types(element, types);
        words >> name >> count;
        check_count(name, count);
        element = name;
        types.clear();
      } else if (keyword == "property") {
        if (element.empty())
          throw Input_error("the header has a property before the first element");
        add_ply_type(words, types);
      } else if (keyword == "end_header")
        return check_ply_types(element, types);
    }
    throw Input_error("has no end_header");
  }

private:
  using Ply_types = std::map<std::string, std::string>; // by the names of properties

  // reads what follows "property": TYPE NAME, or list TYPE TYPE NAME
  static void add_ply_type(std::istream& words, Ply_types& types)
  {
    std::string type, name;
    words >> type >> name;
    if (type == "list")
      words >> name >> name;
    types.emplace(name, type);
  }

  // CGAL reads vertices, faces and halfedges
  static void check_ply_types(const std::string& element, const Ply_types& types)
  {
    const bool is_vertex = element == "vertex" || element == "vertices";
    if (is_vertex)
      for (const char* name : {"x", "y", "z"})
        check_ply_type(element, name, types, {"float", "float32", "double", "float64"});
    if (is_vertex || element == "face" || element == "faces")
      check_colours(element, types);
    if (element == "halfedge")
      for (const char* name : {"source", "target"})
        if (types.count(name) > 0)
          check_ply_type(element, name, types, {"uint", "uint32"});
  }

  static void check_colours(const std::string& element, const Ply_types& types)
  {
    std::set<std::string> found_types;
    for (const char* name : {"red", "green", "blue", "r", "g", "b"})
      if (const auto found = types.find(name); found != types.end())
        found_types.insert(found->second);
    if (found_types.size() > 1)
      throw Input_error("the colours of element \"" + element + "\" are of different types");
  }

  static void check_ply_type(const std::string& element, const std::string& name,
                             const Ply_types& types, const std::set<std::string>& known)
  {
    const auto found = types.find(name);
    if (found == types.end())
      throw Input_error("element \"" + element + "\" has no property \"" + name + "\"");
    if (known.count(found->second) == 0)
      throw Input_error("property \"" + name + "\" of element \"" + element + "\" is of type \"" +
                        found->second + "\", supported are " + list_of(known));
  }

  static std::string list_of(const std::set<std::string>& words)
  {
    std::string result;
    for (const std::string& w : words)
      result += (result.empty() ? "" : " ") + w;
    return result;
  }

  // reads the next word that is not in a comment
  void next_word(std::string& word)
  {
    while (m_in >> word && word[0] == '#')
      m_in.ignore((std::numeric_limits<std::streamsize>::max)(), '\n');
  }

  // an element takes a byte at least
  void check_count(const std::string& name, const std::string& text) const
  {
    std::istringstream in(text);
    std::uintmax_t count;
    if (!(in >> count) || !in.eof())
      throw Input_error("\"" + text + "\" is no number of " + name);
    if (count > m_size)
      throw Input_error("is too short for " + text + " of " + name);
  }

  std::ifstream m_in;
  std::uintmax_t m_size;
};

#endif // QUAD_LAYOUTS_EXAMPLES_FILE_HEADER_H
