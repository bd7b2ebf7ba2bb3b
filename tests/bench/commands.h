// Files and commands of the benchmarks.
#pragma once

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace ladderc::bench {

inline void write(const std::filesystem::path &path, const std::string &text) {
  std::ofstream(path) << text;
}

inline int run(const std::string &command) {
  std::fflush(stdout);
  return std::system(command.c_str());
}

/// Seconds that the command took.
inline double timed(const std::string &command, int &code) {
  const auto start = std::chrono::steady_clock::now();
  code = run(command);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The C++ compiler: $CXX, or g++.
inline std::string compiler() {
  const char *cxx = std::getenv("CXX");
  return cxx && *cxx ? cxx : "g++";
}

}  // namespace ladderc::bench
