// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `docs`: pages, shell completion and the manual page, generated from the declarations
// of keys, models, quantities and options.
#include "app/frame/commands.hpp"
#include "case/reading/case_reader.hpp"
#include "modelling/program/provenance.hpp"
#include "modelling/registry.hpp"
#include "result/quantities.hpp"
#include "result/write/case_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace rollfem::app {

namespace {

/// The option's names ("-o --output"), or the allowed words of a positional argument.
std::string option_words(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) words += " -" + name;
    for (const std::string& name : option->get_lnames()) words += " --" + name;
  }
  return words.empty() ? words : words.substr(1);
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

/// Escapes text for troff: no line starts a request, no break at hyphens.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
      result += "\\&", result += c;
    else
      result += c;
  }
  return result;
}

/// "-o, --output TEXT", bold except for the user's value.
std::string roff_name(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames())
    names += (names.empty() ? "" : ", ") + ("-" + name);
  for (const std::string& name : option.get_lnames())
    names += (names.empty() ? "" : ", ") + ("--" + name);
  if (names.empty()) return fmt::format("\\fI{}\\fR", roff(option.get_name(true)));
  const bool flag = option.get_expected_max() == 0;
  return fmt::format("\\fB{}\\fR{}", roff(names), flag ? "" : " \\fIVALUE\\fR");
}

std::string roff_options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options())
    text += fmt::format(".TP\n{}\n{}\n", roff_name(*option), roff(option->get_description()));
  return text;
}

/// Script for `source` that completes commands, options, models and case files.
std::string bash_completion(const CLI::App& program, const contact::ModelRegistry& models) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    names.push_back(command->get_name());
    cases += fmt::format("    {}) words='{}' ;;\n", command->get_name(), option_words(*command));
  }
  return fmt::format(R"(# bash completion of rollfem, made by `rollfem docs bash`
_rollfem() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} words=''
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W '{} help --help --version' -- "$current"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case $before in
    -m | --model | --models | --reference) words='{}' ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
  case $current in
    -*) ;;
    *)
      local kind=toml
      [ "${{COMP_WORDS[1]}}" != convert ] || kind=inp
      COMPREPLY+=($(compgen -f -X "!*.$kind" -- "$current") $(compgen -d -- "$current")) ;;
  esac
}}
complete -o filenames -F _rollfem rollfem ./rollfem
)",
                     joined(names), cases, joined(models.names()));
}

/// The same for zsh: the file _rollfem in a folder of $fpath.
std::string zsh_completion(const CLI::App& program, const contact::ModelRegistry& models) {
  std::string named;
  std::string cases;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    std::string sentence = command->get_description();
    std::replace(sentence.begin(), sentence.end(), '\'', ' ');
    named += fmt::format("      '{}:{}'\n", command->get_name(), sentence);
    cases += fmt::format("    {}) compadd -- {} ;;\n", command->get_name(), option_words(*command));
  }
  return fmt::format(R"(#compdef rollfem
# zsh completion of rollfem, made by `rollfem docs zsh`
_rollfem() {{
  local -a commands
  if (( CURRENT == 2 )); then
    commands=(
{}    )
    _describe command commands
    return
  fi
  case $words[CURRENT-1] in
    -m|--model|--models|--reference) compadd -- {}; return ;;
  esac
  case $words[2] in
{}  esac
  if [[ $words[2] == convert ]]; then _files -g '*.inp'; else _files -g '*.toml'; fi
}}
_rollfem "$@"
)",
                     named, joined(models.names()), cases);
}

/// The manual page rollfem(1) in troff.
std::string manual_page(const CLI::App& program, const std::string& version) {
  std::string text = fmt::format(
      ".TH ROLLFEM 1 \"\" \"rollfem {}\"\n.SH NAME\nrollfem \\- rolling contact of wheel and "
      "rail\n.SH SYNOPSIS\n\\fBrollfem\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH "
      "DESCRIPTION\nRolling contact of wheel and rail by closed forms, half\\-spaces, finite "
      "elements and a hybrid of these. A case file states the problem; the result is a folder with "
      "report.html to read first. Units are mm, N, MPa, s and rad.\n.SH COMMANDS\n",
      roff(version));
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    text += fmt::format(".SS {}\n{}\n", command->get_name(), roff(command->get_description()));
    text += roff_options(*command);
    const std::string footer = command->get_footer();
    if (!footer.empty())
      text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(footer.substr(0, footer.find("\n\n"))));
  }
  return text +
         ".SH EXIT STATUS\n0: done. 1: no solution, less accurate than asked, or the output "
         "could not be written (disk full). 2: the call, a "
         "case file or another input is wrong.\n.SH ENVIRONMENT\n.TP\nROLLFEM_CACHE\nFolder where "
         "the model hybrid stores corrections for other runs; default: ~/.cache/rollfem; empty: "
         "store nothing.\n.SH FILES\n.TP\nCASE.toml\nA case file: \\fBrollfem new\\-case\\fR "
         "prints one, \\fBrollfem docs case\\-file\\fR every "
         "key.\n.TP\nresults/CASE/\nreport.html, summary.json, results.h5, tables and figures.\n";
}

std::string page_text(const std::string& page, const CLI::App& program,
                      const contact::ModelRegistry& models) {
  if (page == "bash") return bash_completion(program, models);
  if (page == "zsh") return zsh_completion(program, models);
  if (page == "man") return manual_page(program, modelling::version());
  if (page == "schema") return result::case_schema(modelling::known_names(models));
  if (page == "models") return modelling::models_markdown(models);
  if (page == "quantities") return contact::quantities_markdown();
  return contact::case_reference_markdown(modelling::known_names(models));
}

}  // namespace

void add_docs(CLI::App& program, Call& call) {
  const auto page = std::make_shared<std::string>();
  CLI::App* docs = program.add_subcommand("docs", "print a generated page of the documentation");
  docs->add_option("page", *page,
                   "case-file, models; quantities: the table in docs/results.md; schema: JSON "
                   "schema of case files, for completion and checks in editors; bash, zsh: shell "
                   "completion; man: the manual page")
      ->required()
      ->check(one_of({"case-file", "models", "quantities", "schema", "bash", "zsh", "man"}));
  docs->footer("example: rollfem docs case-file > docs/case-file.md");
  docs->callback([page, &call, &program] { std::cout << page_text(*page, program, call.models); });
}

}  // namespace rollfem::app
