// SPDX-License-Identifier: BSD-3-Clause
#include "deduplicate.h"

#include "complaints.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <array>
#include <string>
#include <variant>

namespace fca::checks {

namespace {

/// Both say it; the latter is dropped.
struct Twice {
  Code kept;
  Code dropped;
  bool says_cost = false;   ///< What is dropped is what happens because of it.
  bool of_one_key = false;  ///< Both name the key.
};

constexpr std::array kTwice = {
    // The matrix's dt is the place, its key is not.
    Twice{Code::kMatrixNotFloat, Code::kOrbslamPoseOfDoubles, false, true},
    // A missing key stands nowhere: where it should stand the reader knows.
    Twice{Code::kOpencvPoseMissing, Code::kCvHalfAPose},
    Twice{Code::kWoodscapeJsonMissing, Code::kPythonKeyMissing, false, true},
    Twice{Code::kWoodscapeJsonMissingKey, Code::kPythonKeyMissing, false, true},
    Twice{Code::kWoodscapeJsonCarla, Code::kPythonKeyMissing, false, true},
    Twice{Code::kCalibResultsInverseMissing, Code::kOcamCoefficientCount},
    Twice{Code::kOpencvReadWithout, Code::kCvDistortionMissing},
    Twice{Code::kOpencvSkewKept, Code::kCvSkewUnused, true, true},
    Twice{Code::kRosSkewKept, Code::kRosSaysSkewUnused, true},
    Twice{Code::kRosCoefficientsOfZeros, Code::kRosSaysCoefficientsOfZeros},
    Twice{Code::kOpencvCameraCount, Code::kCvCameraCount},
    Twice{Code::kKalibrSaysAlphaOutside, Code::kCamchainAlphaBelowOne},
    Twice{Code::kWoodscapeJsonReadByNobody, Code::kProjectionPyIgnores},
    Twice{Code::kMarkRemoved, Code::kYamlDirectiveMissing},
    Twice{Code::kLayoutOfOpenCv, Code::kYamlDirectiveMissing},
    Twice{Code::kOrbslam3EucmWithoutType, Code::kOrbslamOldTypeMissing},
    // DSO names lines at most.
    Twice{Code::kCameraTxtAtan, Code::kDsoUnknownLens},
    Twice{Code::kCameraTxtMode, Code::kDsoOutputUnknown},
    Twice{Code::kCameraTxtNoOutput, Code::kDsoOutputUnknown},
    Twice{Code::kCameraTxtFull, Code::kDsoFullUnfinished},
    Twice{Code::kCameraTxtSizesDiffer, Code::kDsoSizesDiffer},
    Twice{Code::kDsoNotRectified, Code::kCameraTxtNotRectified},
    Twice{Code::kCameraTxtFifthNumber, Code::kDsoFifthNumberIgnored},
};

/// What says it: the finding, a clause in it, or the fix after which it is named.
const Message* find_said(const Finding& finding, Code code) {
  return find_clause(finding.kind == Code{} ? finding.facts : finding.remedy,
                     [code](const Message& each) { return each.code == code; });
}

bool share_a_name(const Message& a, const Message& b) {
  return std::ranges::any_of(a.arguments, [&b](const Argument& each) {
    return std::holds_alternative<std::string>(each.value) && std::ranges::find(b.arguments, each) != b.arguments.end();
  });
}

bool has_place(const Finding& finding) { return finding.where.offset > 0 || finding.where.length > 0; }

bool is_dropped(const Twice& twice, const Finding& kept, const Finding& other) {
  const Message* const said = find_said(other, twice.dropped);
  return said != nullptr && (!twice.of_one_key || share_a_name(*find_said(kept, twice.kept), *said));
}

void take_from(const Finding& other, Finding& finding) {
  finding.severity = std::max(finding.severity, other.severity);
  if (!has_place(finding)) finding.where = other.where;
  if (fix_of(finding).empty() && !fix_of(other).empty()) {
    finding.remedy = other.remedy.is_said() ? other.remedy : other.facts;
  }
  if (!finding.edit) finding.edit = other.edit;
}

}  // namespace

void deduplicate(CheckReport& report) {
  std::vector<Finding>& findings = report.findings;
  for (const Twice& twice : kTwice) {
    for (std::size_t kept = 0; kept < findings.size(); ++kept) {
      if (find_said(findings[kept], twice.kept) == nullptr) continue;
      for (std::size_t other = 0; other < findings.size();) {
        if (other == kept || !is_dropped(twice, findings[kept], findings[other])) {
          ++other;
          continue;
        }
        take_from(findings[other], findings[kept]);
        if (twice.says_cost) {
          findings[kept].outcome = {Code::kItsCost, {findings[other].facts}};
        }
        findings.erase(findings.begin() + static_cast<std::ptrdiff_t>(other));
        if (other < kept) --kept;
      }
    }
  }
}

}  // namespace fca::checks
