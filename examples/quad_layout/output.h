// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_EXAMPLES_OUTPUT_H
#define QUAD_LAYOUTS_EXAMPLES_OUTPUT_H

#include <CGAL/Quad_layouts/exceptions.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Files of a folder that appear all together or not at all: they are written under temporary names,
// and renamed when all are complete.
class Output_files
{
public:
  using Writer = std::function<bool(std::ostream&)>;

  explicit Output_files(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  ~Output_files()
  {
    std::error_code ignored;
    for (const auto& name : m_names)
      std::filesystem::remove(temporary(name), ignored);
  }

  void write(const std::string& name, const Writer& writer)
  {
    std::filesystem::create_directories(m_folder);
    m_names.push_back(name);
    std::ofstream out(temporary(name), std::ios::binary);
    if (!out || !writer(out) || !out.flush())
      throw CGAL::Quad_layouts::Error("cannot write " + (m_folder / name).string());
  }

  void commit()
  {
    for (const auto& name : m_names)
      std::filesystem::rename(temporary(name), m_folder / name);
    m_names.clear();
  }

private:
  std::filesystem::path temporary(const std::string& name) const
  {
    return m_folder / ("." + name + ".part");
  }

  std::filesystem::path m_folder;
  std::vector<std::string> m_names;
};

#endif // QUAD_LAYOUTS_EXAMPLES_OUTPUT_H
