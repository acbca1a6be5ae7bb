// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_TEST_CAUGHT_OUTPUT_H
#define QUAD_LAYOUTS_TEST_CAUGHT_OUTPUT_H

#include <cstddef>
#include <cstdio>
#include <vector>

#include <unistd.h>

// Moves the standard output and error streams into a file while it lives.
class Caught_output
{
public:
  Caught_output()
  {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      std::fflush(nullptr);
      m_saved.push_back(dup(stream));
      dup2(fileno(m_file), stream);
    }
  }
  ~Caught_output()
  {
    restore();
    std::fclose(m_file);
  }

  // ends it and returns how much was written
  long restore()
  {
    std::fflush(nullptr);
    for (std::size_t i = 0; i < m_saved.size(); ++i) {
      dup2(m_saved[i], int(i) + STDOUT_FILENO);
      close(m_saved[i]);
    }
    m_saved.clear();
    std::fseek(m_file, 0, SEEK_END);
    return std::ftell(m_file);
  }

private:
  std::FILE* m_file = std::tmpfile();
  std::vector<int> m_saved;
};

#endif // QUAD_LAYOUTS_TEST_CAUGHT_OUTPUT_H
