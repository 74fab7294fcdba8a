// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/format_name.h>

#include "orbslam3/layout.h"

#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

/// Files of a format that another program's name stands for.
struct Named {
  std::string_view format;
  FormatName name;
  bool (*is)(const text::Document& document);
};

bool is_orbslam2(const text::Document& document) {
  return document.root().is_mapping() && orbslam3::style_of(document) == orbslam3::Style::kOrbSlam2;
}

constexpr std::array kNamed = {Named{"orbslam3", {"orbslam2", "ORB-SLAM2 settings"}, is_orbslam2}};

bool has_further_names(const Format& format) { return std::ranges::find(kNamed, format.id, &Named::format) != kNamed.end(); }

}  // namespace

FormatName name_of(const Format& format, const text::Document& document) {
  for (const Named& each : kNamed) {
    if (each.format == format.id && each.is(document)) return each.name;
  }
  return {format.id, format.title};
}

FormatName name_of(const Format& format, const text::Source& source) {
  Diagnostics said_before;
  const std::optional<text::Document> document =
      has_further_names(format) ? text::parse_document(source, said_before) : std::nullopt;
  return document ? name_of(format, *document) : FormatName{format.id, format.title};
}

std::vector<FormatName> further_names(const Format& format) {
  std::vector<FormatName> names;
  for (const Named& each : kNamed) {
    if (each.format == format.id) names.push_back(each.name);
  }
  return names;
}

}  // namespace fca
