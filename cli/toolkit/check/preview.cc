// SPDX-License-Identifier: BSD-3-Clause
#include "check/preview.h"

#include <filesystem>

namespace fca {

ConvertResult preview_conversion(const std::string& file, const Inputs& inputs, const consumers::Consumer& program,
                                 Files& files, bool rewrite) {
  ConvertRequest request;
  request.inputs = inputs;
  request.inputs.files = {file};
  request.to = find_format(program.format);
  request.program = &program;
  request.model = program.writing.model.empty() ? nullptr : find_model(program.writing.model);
  request.layout = FormatLayout::find(*request.to, program.writing.layout);
  request.extension = std::filesystem::path(program.writing.file_name).extension().string();
  request.rewrite = rewrite;
  ConvertResult result = convert(request, files);
  result.files.clear();
  return result;
}

}  // namespace fca
