// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/built_page.hpp"

#include "hardball_viewer_page_files.hpp"

namespace hardball::viewer {

Page built_page() {
  return {page_files::index_html(), page_files::page_css(), page_files::page_js()};
}

}  // namespace hardball::viewer
