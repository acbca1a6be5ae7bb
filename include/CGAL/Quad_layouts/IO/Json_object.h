// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_IO_JSON_OBJECT_H
#define CGAL_QUAD_LAYOUTS_IO_JSON_OBJECT_H

#include <cmath>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace IO {

/*!
\ingroup PkgQuadLayoutsIO

is an object of the JSON format: names with values, in the order in which they are added. It is
enough to write statistics, and not meant for more.
*/
class Json_object
{
public:
  Json_object& add(const std::string& name, int value)
  {
    return append(name, std::to_string(value));
  }
  /// adds a number with all its digits, or `null` for what JSON has no number for: infinity and
  /// NaN.
  Json_object& add(const std::string& name, double value)
  {
    if (!std::isfinite(value))
      return append(name, "null");
    std::ostringstream text;
    text.precision((std::numeric_limits<double>::max_digits10));
    text << value;
    return append(name, text.str());
  }
  Json_object& add(const std::string& name, const std::string& value)
  {
    return append(name, quoted(value));
  }
  /// adds an object as it is now.
  Json_object& add(const std::string& name, const Json_object& value)
  {
    std::ostringstream text;
    text << value;
    return append(name, indented(text.str()));
  }

  /// writes the object, a line for each value, without a line break at the end.
  friend std::ostream& operator<<(std::ostream& out, const Json_object& object)
  {
    const char* separator = "\n";
    out << '{';
    for (const auto& member : object.m_members) {
      out << separator << "  " << quoted(member.first) << ": " << member.second;
      separator = ",\n";
    }
    return out << (object.m_members.empty() ? "}" : "\n}");
  }

private:
  Json_object& append(const std::string& name, std::string text)
  {
    m_members.emplace_back(name, std::move(text));
    return *this;
  }

  static std::string quoted(const std::string& text)
  {
    static const char* const digits = "0123456789abcdef";
    std::string result = "\"";
    for (const char c : text) {
      const auto code = static_cast<unsigned char>(c);
      if (c == '"' || c == '\\')
        result += {'\\', c};
      else if (code < 0x20)
        result += {'\\', 'u', '0', '0', digits[code / 16], digits[code % 16]};
      else
        result += c;
    }
    return result + '"';
  }

  static std::string indented(const std::string& text)
  {
    std::string result;
    for (const char c : text)
      result += c == '\n' ? "\n  " : std::string(1, c);
    return result;
  }

  std::vector<std::pair<std::string, std::string>> m_members;
};

} // namespace IO
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_IO_JSON_OBJECT_H
