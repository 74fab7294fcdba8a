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
    std::optional<Written> each;
    if (request.inputs.change.changes_nothing())
      each = write_each_into_its_own(source, rig, *result.to, options, result.diagnostics);
    if (each || result.diagnostics.has_errors()) return each;
    // The first file may be edited; the text of the others is lost in any case.
    if (source.format == result.to) options.joined = std::span(source.documents).subspan(base.document != nullptr ? 1 : 0);
  }
  std::optional<Written> written = write_calibration(*result.to, base.document, rig, options, result.diagnostics);
  if (!written || base.document == nullptr || !request.verify || request.rewrite) return written;
  const bool edited = written->files.front().document.edited();
  const bool loads = (edited || base.into != nullptr) && fix_kept_text(*result.to, rig, *written, views, result.diagnostics);
  if (loads || keeps_text(request, base)) return written;
  const bool asked_for = !options.layout.empty() || edited;
  // The program must be able to read what an input becomes: a camchain with the first line that OpenVINS needs is no base for
  // Kalibr. A file of --into belongs to the user, who may have another program for it.
  const text::Document* owners = base.into != nullptr ? base.document : nullptr;
  const Message refusal = asked_for ? newly_refused(*written, rig, owners, views) : Message{};
  if (!refusal.is_said()) return written;
  options.rewrite = true;
  result.diagnostics.add(Code::kLayoutNotKept, {refusal});
  return write_calibration(*result.to, base.document, rig, options, result.diagnostics);
}

}  // namespace fca
