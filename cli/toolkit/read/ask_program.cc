// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/program_names.h>
#include <fca/formats/verdict.h>
#include <fca/normalised_id.h>
#include <fca/toolkit/programs.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace fca {

namespace {

/// True if a program reads the same cameras, with the same errors, in both proofs.
bool same_cameras(const std::vector<CameraProof>& a, const std::vector<CameraProof>& b) {
  return std::ranges::equal(a, b, [](const CameraProof& x, const CameraProof& y) {
    return x.name == y.name && x.model == y.model && x.width == y.width && x.height == y.height && x.misread == y.misread &&
           x.agrees == y.agrees && x.max_diff_px == y.max_diff_px;
  });
}

/// True if both lists contain the same messages in the same order.
bool have_same_messages(const std::vector<consumers::Complaint>& a, const std::vector<consumers::Complaint>& b) {
  return std::ranges::equal(a, b, {}, &consumers::Complaint::facts, &consumers::Complaint::facts);
}

/// True if the two proofs have the same results, so that their modes can be reported together.
bool have_same_results(const ProofResult& a, const ProofResult& b) {
  return a.loads == b.loads && have_same_messages(a.refusals, b.refusals) && have_same_messages(a.warnings, b.warnings) &&
         a.poses == b.poses && same_cameras(a.cameras, b.cameras);
}

}  // namespace

std::vector<std::string> program_ids() {
  std::vector<std::string> ids;
  for (const consumers::Consumer& program : consumers::all_consumers()) ids.emplace_back(program.id);
  return ids;
}

const consumers::Consumer* find_program(std::string_view typed) {
  const auto all = consumers::all_consumers();
  const auto found = std::ranges::find_if(
      all, [typed](const consumers::Consumer& each) { return normalised_id(each.id) == normalised_id(typed); });
  if (found != all.end()) return &*found;
  if (const Format* format = find_format(typed)) return consumers::own_program(format->id, true);
  const ProgramName* name = find_program_name(typed);
  if (name == nullptr || !name->is_served()) return nullptr;
  if (!name->consumer.empty()) return consumers::find_consumer(name->consumer);
  const auto served = std::ranges::find_if(all, [name](const consumers::Consumer& each) {
    return each.format == name->format && each.cameras && each.writing.layout == name->layout;
  });
  return served == all.end() ? nullptr : &*served;
}

const consumers::Consumer& reader_of(const consumers::Consumer& program, bool with_cameras) {
  if (!program.cameras || with_cameras) return program;  // the user named its reader of files without cameras
  const auto all = consumers::all_consumers();
  const auto other = std::ranges::find_if(all, [&](const consumers::Consumer& each) {
    return each.format == program.format && each.other_syntax == program.other_syntax && each.cameras == with_cameras;
  });
  return other == all.end() ? program : *other;
}

ProgramReading ask_program(const consumers::Consumer& program, const Calibration& calibration, const Inputs& inputs,
                           std::span<const Finding> findings) {
  ProgramReading reading;
  reading.program = &reader_of(program, !calibration.rig.cameras.empty());
  const Format& format = *calibration.format;
  reading.reads_format = reading.program->reads(format.id);
  if (!reading.reads_format) return reading;
  constexpr std::array<std::string_view, 1> kNoModes = {""};
  const std::span<const std::string_view> modes =
      format.modes.empty() ? std::span<const std::string_view>(kNoModes) : format.modes;
  const text::Source& source = calibration.documents[calibration.with_cameras].source();
  for (const std::string_view mode : modes) {
    consumers::LoadOptions options = load_options(read_options(inputs), std::string(mode));
    options.file_name = source.name;
    ProofResult proof =
        prove(*reading.program, source.bytes, options, calibration.rig, inputs.max_angle_rad.value_or(std::numbers::pi));
    const auto same = std::ranges::find_if(
        reading.modes, [&proof](const ProgramReading::Mode& each) { return have_same_results(each.proof, proof); });
    ProgramReading::Mode& found = same != reading.modes.end() ? *same : reading.modes.emplace_back();
    if (!mode.empty()) found.names.emplace_back(mode);
    found.proof = std::move(proof);
    VerdictFacts facts;
    facts.to = &format;
    facts.mode = mode;
    facts.proofs = std::span(&found.proof, 1);
    facts.findings = findings;
    facts.rig = &calibration.rig;
    found.verdict = decide(facts);
  }
  return reading;
}

}  // namespace fca
