// SPDX-License-Identifier: BSD-3-Clause
#include "write_rig.h"

#include "joined_files.h"
#include "proving.h"

#include <fca/code.h>

#include <span>

namespace fca {

namespace {

WriteOptions write_options(const ConvertRequest& request, const Base& base, std::vector<std::string> replaced) {
  WriteOptions options;
  options.keeps_layout = keeps_text(request, base);
  options.replaced = std::move(replaced);
  options.sensor = name_of(request.mode);
  options.layout = name_of(request.layout);
  options.frame_rate_hz = request.frame_rate_hz;
  options.max_angle_rad = request.inputs.max_angle_rad;
  options.rewrite = request.rewrite;
  options.adopted = base.adopted;
  options.extension = request.extension;
  if (request.program != nullptr) options.models_taken = request.program->writing.models_taken;
  options.lenses_alone = request.program != nullptr && request.program->writing.lenses_alone;
  return options;
}

}  // namespace

std::optional<Written> write_rig(const Calibration& source, const Rig& rig, const Base& base, const ConvertRequest& request,
                                 std::vector<std::string> replaced, LoadedViews& views, ConvertResult& result) {
  WriteOptions options = write_options(request, base, std::move(replaced));
  if (source.one_format && source.format == result.to) options.input = source.documents;
  if (source.documents.size() > 1 && base.into == nullptr && !request.rewrite && request.inputs.join) {
    std::optional<Written> one_by_one;
    if (request.inputs.change.changes_nothing())
      one_by_one = write_each_into_its_own(source, rig, *result.to, options, result.diagnostics);
    if (one_by_one || result.diagnostics.has_errors()) return one_by_one;
    // The first file may be edited as the base. The comments of the other files are lost.
    if (source.format == result.to) options.joined = std::span(source.documents).subspan(base.document != nullptr ? 1 : 0);
  }
  std::optional<Written> written = write_calibration(*result.to, base.document, rig, options, result.diagnostics);
  if (!written || base.document == nullptr || !request.verify || request.rewrite) return written;
  const bool is_edited = written->files.front().document.edited();
  const bool loads = (is_edited || base.into != nullptr) && fix_kept_text(*result.to, rig, *written, views, result.diagnostics);
  if (loads || keeps_text(request, base)) return written;
  const bool must_load = !options.layout.empty() || is_edited;
  // The program must load an edited input: for example, Kalibr does not load a camchain with the first line that OpenVINS
  // needs. The file of --into may be for another program of the user, so that a refusal is accepted if the program already
  // refused it.
  const text::Document* may_be_refused = base.into != nullptr ? base.document : nullptr;
  const Message refusal = must_load ? newly_refused(*written, rig, may_be_refused, views) : Message{};
  if (!refusal.is_said()) return written;
  options.rewrite = true;
  result.diagnostics.add(Code::kLayoutNotKept, {refusal});
  return write_calibration(*result.to, base.document, rig, options, result.diagnostics);
}

}  // namespace fca
