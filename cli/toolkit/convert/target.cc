// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/program_names.h>
#include <fca/toolkit/target.h>

namespace fca {

std::optional<Target> find_target(std::string_view name) {
  if (const Format* format = find_format(name)) return Target{format};
  const ProgramName* program = find_program_name(name);
  if (program == nullptr || !program->is_served()) return std::nullopt;
  Target target{find_format(program->format)};
  if (!program->consumer.empty()) target.program = consumers::find_consumer(program->consumer);
  target.layout = FormatLayout::find(*target.format, program->layout);
  target.extension = program->extension;
  return target;
}

}  // namespace fca
