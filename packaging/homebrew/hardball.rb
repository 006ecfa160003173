# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Program and library, from the clone that this formula is in; a tap has url and sha256 of a release in place of `head`.
class Hardball < Formula
  desc "Every collision among many moving spheres, exactly and in order"
  license "MIT"
  head "file://#{File.expand_path("../..", __dir__)}", using: :git, branch: "main"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "cpp-httplib" => :build
  depends_on "nlohmann-json" => :build
  depends_on "pkgconf" => :build
  depends_on "tomlplusplus" => :build
  depends_on "xxhash" => :build
  depends_on "fmt"
  # The standard library of macOS reads no decimal fractions (std::from_chars).
  depends_on :linux
  depends_on "zstd"

  def install
    options = %w[MPI POLISH TESTS EXAMPLES].map { |part| "-DHARDBALL_#{part}=OFF" }
    system "cmake", "-S", ".", "-B", "build", *options, *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    scenario = pkgshare.parent/"doc/hardball/examples/newtons_cradle.toml"
    assert_match "event_log_hash", shell_output("#{bin}/hardball run #{scenario} --json --quiet")
  end
end
