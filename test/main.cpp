// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#define BOOST_TEST_MODULE Quad_layouts
#include <boost/test/unit_test.hpp>
