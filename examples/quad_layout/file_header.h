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
#include <sstream>
#include <string>

// Looks at the header of a file before CGAL's readers do, which believe it: they get memory for as
// many elements as it announces, and a PLY property belongs to the element before it.
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
    bool has_element = false;
    for (std::string line; std::getline(m_in, line);) {
      std::istringstream words(line);
      std::string keyword, name, count;
      words >> keyword >> name >> count;
      if (keyword == "end_header")
        return;
      if (keyword == "element") {
        has_element = true;
        check_count(name, count);
      } else if (keyword == "property" && !has_element)
        throw Input_error("the header has a property before the first element");
    }
    throw Input_error("has no end_header");
  }

private:
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
