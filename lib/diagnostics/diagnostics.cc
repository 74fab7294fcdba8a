// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/diagnostics.h>

namespace fca {

std::string id_of(const Message& message) { return std::string(info(message.code).id); }

std::string id_of(const Diagnostic& diagnostic) {
  return std::string(info(diagnostic.kind != Code{} ? diagnostic.kind : diagnostic.facts.code).id);
}

void Diagnostics::add(Code code, std::vector<Argument> arguments, SourceRange where) {
  add(info(code).severity, code, std::move(arguments), std::move(where));
}

void Diagnostics::add(Severity severity, Code code, std::vector<Argument> arguments, SourceRange where) {
  add(Diagnostic{severity, {code, std::move(arguments)}, std::move(where)});
}

}  // namespace fca
