// SPDX-License-Identifier: BSD-3-Clause
#include "told_once.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace fca::checks {

namespace {

/// A finding by its code and a part of its message.
struct Said {
  std::string_view code;
  std::string_view words;

  [[nodiscard]] bool by(const Finding& finding) const {
    return id_of(finding) == code && message_of(finding).find(words) != std::string::npos;
  }
};

struct Twice {
  Said kept;
  Said dropped;
  bool says_cost = false;   ///< What is dropped is what happens because of it.
  bool of_one_key = false;  ///< Both name the key, which begins what is kept.
};

constexpr std::array kTwice = {
    // The matrix's dt is the place, its key is not.
    Twice{{"matrix-not-float", ""}, {"program-misreads", " is dt: "}, false, true},
    // A missing key stands nowhere: where it should stand the reader knows.
    Twice{{"pose-missing", "is missing"}, {"program-refuses", " is missing beside "}},
    Twice{{"missing-key", "'extrinsic'"}, {"program-refuses", "'extrinsic'"}},
    Twice{{"missing-key", "'quaternion'"}, {"program-refuses", "'quaternion'"}},
    Twice{{"carla-translation", ""}, {"program-refuses", "'translation'"}},
    Twice{{"inverse-missing", ""}, {"program-refuses", "inverse polynomial has"}},
    Twice{{"distortion-missing", ""}, {"program-misreads", "projects without distortion"}},
    Twice{{"skew", ""}, {"program-misreads", "has a skew of"}, true, true},
    Twice{{"program-refuses", "MC-Calib's reader stops"}, {"program-refuses", "maps camera_0"}},
    Twice{{"program-refuses", "Kalibr wants 0 <= alpha < 1"}, {"program-refuses", "Kalibr demands alpha < 1"}},
    Twice{{"program-ignores", "is read by nobody"}, {"program-misreads", "only k1 to k4 are read"}},
    Twice{{"byte-order-mark", ""}, {"program-refuses", "the first line is not %YAML"}},
    Twice{{"yaml-layout", ""}, {"program-refuses", "the first line is not %YAML"}},
    Twice{{"eucm-without-type", ""}, {"program-refuses", "Camera.type is missing"}},
    // DSO names lines at most.
    Twice{{"program-refuses", "DSO knows no lens ATAN"}, {"program-refuses", "DSO wants RadTan"}},
    Twice{{"program-refuses", "line 3 must be exactly crop"}, {"program-refuses", "DSO wants exactly crop"}},
    Twice{{"program-refuses", "DSO wants a line 3"}, {"program-refuses", "DSO wants exactly crop"}},
    Twice{{"program-refuses", "DSO has not written"}, {"program-refuses", "line 3 is full"}},
    Twice{{"program-refuses", "differ: DSO stops"}, {"program-refuses", "differ; DSO exits"}},
    Twice{{"program-misreads", "line 3 is none"}, {"program-ignores", "line 3 is none"}},
    Twice{{"program-ignores", "the fifth number of Pinhole"}, {"program-misreads", "the fifth number of Pinhole"}},
    Twice{{"relative-by-centre", ""}, {"program-misreads", "cx and cy are below 1"}},
    // One follows from the other.
    Twice{{"relative-by-centre", ""}, {"focal-length-not-in-pixels", ""}},
    Twice{{"relative-by-centre", ""}, {"not-a-camera", "not a finite number"}},
};

bool has_place(const Finding& finding) { return finding.where.offset > 0 || finding.where.length > 0; }

bool is_dropped(const Twice& twice, const Finding& kept, const Finding& other) {
  if (!twice.dropped.by(other)) return false;
  const std::string message = message_of(kept);
  const std::string key = message.substr(0, message.find(' '));
  return !twice.of_one_key || message_of(other).find(key + " ") != std::string::npos;
}

void take_from(const Finding& other, Finding& finding) {
  finding.severity = std::max(finding.severity, other.severity);
  if (!has_place(finding)) finding.where = other.where;
  if (fix_of(finding).empty() && !fix_of(other).empty()) {
    finding.remedy = other.remedy.is_said() ? other.remedy : other.facts;
  }
  if (!finding.mend) finding.mend = other.mend;
}

}  // namespace

void tell_once(CheckReport& report) {
  std::vector<Finding>& findings = report.findings;
  for (const Twice& twice : kTwice) {
    for (std::size_t kept = 0; kept < findings.size(); ++kept) {
      if (!twice.kept.by(findings[kept])) continue;
      for (std::size_t other = 0; other < findings.size();) {
        if (other == kept || !is_dropped(twice, findings[kept], findings[other])) {
          ++other;
          continue;
        }
        take_from(findings[other], findings[kept]);
        if (twice.says_cost) {
          findings[kept].outcome = {Code::kItsCost, {facts_of(findings[other])}};
        }
        findings.erase(findings.begin() + static_cast<std::ptrdiff_t>(other));
        if (other < kept) --kept;
      }
    }
  }
}

}  // namespace fca::checks
