// SPDX-License-Identifier: BSD-3-Clause
// yaml-json FILE: what yaml-cpp itself reads from a file, as JSON for tests/programs: maps, lists, and scalars that are numbers
// to yaml-cpp (as<double>) or else words. Exits with 1 where yaml-cpp refuses.
#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <exception>
#include <string>

namespace {

std::string quoted(const std::string& word) {
  std::string text = "\"";
  for (const char c : word) {
    if (c == '"' || c == '\\') text += '\\';
    if (c == '\n') {
      text += "\\n";
    } else {
      text += c;
    }
  }
  return text + "\"";
}

void print(const YAML::Node& node) {
  double number = 0.0;
  if (node.IsMap()) {
    const char* before = "{";
    for (const auto& entry : node) {
      std::printf("%s%s:", before, quoted(entry.first.Scalar()).c_str());
      print(entry.second);
      before = ",";
    }
    std::fputs(node.size() == 0 ? "{}" : "}", stdout);
  } else if (node.IsSequence()) {
    const char* before = "[";
    for (const YAML::Node& item : node) {
      std::fputs(before, stdout);
      print(item);
      before = ",";
    }
    std::fputs(node.size() == 0 ? "[]" : "]", stdout);
  } else if (node.IsScalar() && YAML::convert<double>::decode(node, number)) {
    std::printf("%.17g", number);
  } else {
    std::fputs(node.IsScalar() ? quoted(node.Scalar()).c_str() : "null", stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    print(YAML::LoadFile(argc == 2 ? argv[1] : ""));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
