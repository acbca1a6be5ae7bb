// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_IO_LINE_READER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_IO_LINE_READER_H

#include <CGAL/Quad_layouts/exceptions.h>

#include <Eigen/Core>

#include <istream>
#include <locale>
#include <sstream>
#include <string>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Reads a text of words and numbers, whose comments begin with # and end with the line, and knows
// the line for messages.
class Line_reader
{
public:
  // takes the stream, and what it is for in messages
  Line_reader(std::istream& in, std::string name) : m_in(in), m_name(std::move(name)) {}

  // returns the next line that is not empty, without comment and white space around it; an empty
  // string at the end. What was left of the line before is skipped.
  std::string line()
  {
    for (std::string text; std::getline(m_in, text);) {
      ++m_number;
      text = trimmed(text.substr(0, text.find('#')));
      if (text.empty())
        continue;
      m_words = std::istringstream(text);
      m_words.imbue(std::locale::classic());
      return text;
    }
    m_words = std::istringstream();
    return "";
  }

  // reads a word of this line; an empty string at its end
  std::string word()
  {
    std::string result;
    m_words >> result;
    return result;
  }

  // reads a number, from the next line if there is no other on this one
  template <class Number>
  Number number()
  {
    if ((m_words >> std::ws).eof() && line().empty())
      throw Invalid_file(m_name + ": ends after line " + std::to_string(m_number) +
                         ", where a number is expected");
    Number result;
    if (!(m_words >> result))
      fail("a number is expected");
    return result;
  }

  Eigen::Vector3d vector()
  {
    const double x = number<double>(), y = number<double>(), z = number<double>();
    return Eigen::Vector3d(x, y, z);
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Invalid_file(m_name + ": line " + std::to_string(m_number) + ": " + message);
  }

private:
  static std::string trimmed(const std::string& text)
  {
    const char* space = " \t\r";
    const std::size_t first = text.find_first_not_of(space);
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(space) - first + 1);
  }

  std::istream& m_in;
  std::string m_name;
  int m_number = 0;
  std::istringstream m_words;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_IO_LINE_READER_H
