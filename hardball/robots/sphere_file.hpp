// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/robots/robot.hpp"

namespace hardball {

/// The spheres of a robot's links, and which links do not meet, as files of cuRobo have them.
struct SphereFile {
  std::vector<Link> links;
  std::vector<std::pair<std::string, std::string>> ignored;
};

/// Reads the spheres of a robot from a file of cuRobo: in YAML, a table `collision_spheres` of links, each
/// with a list of spheres of a `center` of three numbers and a `radius`; and perhaps a table
/// `self_collision_ignore`, which lists for links those that they do not meet. Spheres whose radius is not
/// positive are placeholders; they are left out, and so are links without others. Other keys are passed over.
/// Error: the file cannot be read; it is not what parse_spheres takes.
HARDBALL_EXPORT SphereFile read_spheres(const std::filesystem::path& path);

/// Reads the text of such a file; `name` is what errors call it. Of YAML it knows tables and lists, by
/// indentation or in brackets, plain and quoted text, and comments. Error, with its line: the text is
/// something else; there are no spheres; a sphere has no center of three numbers, or no radius.
HARDBALL_EXPORT SphereFile parse_spheres(std::string_view text, const std::string& name);

}  // namespace hardball
