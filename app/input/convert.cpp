// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `convert`: case files from a CONTACT input file.
#include "app/frame/commands.hpp"
#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "case/reading/case_reader.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "modelling/registry.hpp"
#include "modelling/solving/case_scenes.hpp"
#include "profiles/profiles.hpp"
#include "result/files/files_together.hpp"

#include <fmt/format.h>

#include "convert/contact_reader.hpp"
#include "convert/conversion.hpp"
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::app {

namespace {

namespace fs = std::filesystem;

struct ConvertRequest {
  std::string file;
  std::string directory;  ///< empty: <name of the file>_cases
  std::string cases;      ///< "1-5,8"; empty: all
  bool partial = false;   ///< accept that cases without an equivalent are left out
};

constexpr std::size_t largest_input = 200u << 20;  // bytes

/// Removes written files again unless they are kept.
class Written {
 public:
  explicit Written(const fs::path& directory) : directory_(directory), folders_(directory) {}
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;
  ~Written() {
    if (kept_) return;
    for (const fs::path& path : paths_) remove(path);
  }

  void write(const std::string& name, const std::string& text) {
    const fs::path path = directory_ / name;
    if (fs::exists(path))
      throw contact::InputError(
          fmt::format("convert: {} exists already; do: remove it or name another folder with -o",
                      path.string()));
    paths_.push_back(path);
    result::write_file(path, text);
  }

  void remove(const fs::path& path) const {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  void keep() {
    kept_ = true;
    folders_.keep();
  }

 private:
  fs::path directory_;
  result::MadeFolders folders_;
  bool kept_ = false;
  std::vector<fs::path> paths_;
};

/// Path from case files in `directory` to the folder of the input file; empty: the same folder.
std::string profile_folder(const fs::path& file, const fs::path& directory) {
  const fs::path from = fs::absolute(file).parent_path().lexically_normal();
  const std::string way =
      from.lexically_relative((fs::absolute(directory) / "").lexically_normal()).generic_string();
  return way == "." ? "" : way;
}

std::string case_words(const std::vector<int>& numbers) {
  return (numbers.size() == 1 ? "case " : "cases ") + convert::numbers_text(numbers);
}

/// Refused cases, grouped by identical reasons.
using Refused = std::vector<std::pair<std::vector<std::string>, std::vector<int>>>;

void add(Refused& refused, const std::vector<std::string>& reasons, const std::vector<int>& more) {
  if (more.empty()) return;
  for (auto& [known, numbers] : refused)
    if (known == reasons) {
      numbers.insert(numbers.end(), more.begin(), more.end());
      return;
    }
  refused.push_back({reasons, more});
}

using Cells = std::array<double, 2>;

/// The cells of the case, halved until the patches of all wheels have elements enough.
Cells fine_cells(const contact::Case& input, const modelling::Placed& placed) {
  // A result needs four; the box of a patch may be a little wider than its elements.
  constexpr double fewest = 5.0, most_halvings = 4;
  Cells cells = *input.contact_grid.cell_size;
  for (const contact::Scene& scene : modelling::scenes_of(input, placed).list) {
    const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
    for (int halving = 0; halving < most_halvings; ++halving) {
      if (extent.length < fewest * cells[0]) cells[0] *= 0.5;
      if (extent.width < fewest * cells[1]) cells[1] *= 0.5;
    }
  }
  return cells;
}

/// What `check` says to a written case.
struct Verdict {
  std::string wrong;           ///< why it is refused, or empty
  std::optional<Cells> cells;  ///< the case needs these
  std::optional<profiles::RepairableProfile>
      repairable;  ///< and would be accepted with its repairs
};

/// Reads a written case and, with profiles, places its wheels, as `check` does.
Verdict checked(const fs::path& path, const contact::ModelRegistry& models) {
  Verdict verdict;
  try {
    const contact::Case input = contact::read_case(path.string(), modelling::known_names(models));
    if (!input.has_profiles()) return verdict;
    const modelling::Placed placed = modelling::placed_wheels(input);
    try {
      verdict.cells = fine_cells(input, placed);
      if (verdict.cells == input.contact_grid.cell_size) verdict.cells.reset();
    } catch (const contact::SolveError&) {
      // There is no balance: `run` says why.
    }
  } catch (const contact::FileError&) {
    // A profile that is missing is warned of; it may come.
  } catch (const profiles::RepairableProfile& error) {
    verdict.wrong = error.what();
    verdict.repairable = error;
  } catch (const contact::Failure& error) {
    verdict.wrong = error.what();
  }
  return verdict;
}

/// The case file with other keys, and a note on them.
convert::CaseFile with_keys(convert::CaseFile made, const std::vector<std::string>& keys,
                            const std::string& note) {
  made.text = contact::with_changes(made.text, made.name, keys);
  made.text.insert(made.text.find('\n') + 1, fmt::format("# note: {}\n", note));
  made.notes.push_back(note);
  return made;
}

/// With finer cells than CONTACT's.
convert::CaseFile with_cells(convert::CaseFile made, const Cells& cells) {
  return with_keys(
      std::move(made),
      {fmt::format("contact_grid.cell_size = [{:.12g}, {:.12g}]", cells[0], cells[1])},
      fmt::format(
          "elements of {:g} by {:g} mm instead of DX by DS, which are too few across a patch",
          cells[0], cells[1]));
}

/// With the keys that repair the points of a profile, as CONTACT does unasked.
convert::CaseFile with_repairs(convert::CaseFile made, const profiles::RepairableProfile& profile) {
  const std::string body = profile.of_wheel ? "wheel" : "rail";
  std::vector<std::string> keys;
  for (const std::string& repair : profile.repairs)
    keys.push_back(fmt::format("{}_profile.{}", body, repair));
  return with_keys(std::move(made), keys,
                   fmt::format("points of the profile of the {} are repaired: {}", body,
                               fmt::join(profile.repairs, ", ")));
}

void refuse(const std::string& file, const Refused& refused, bool nothing_left) {
  std::vector<int> all;
  for (const auto& [reasons, numbers] : refused)
    all.insert(all.end(), numbers.begin(), numbers.end());
  std::sort(all.begin(), all.end());
  throw contact::InputError(
      fmt::format("convert: {}: {} {} no equivalent, so nothing was written; do: {}", file,
                  case_words(all), all.size() == 1 ? "has" : "have",
                  nothing_left ? "see docs/coming_from_contact.md for what can be converted"
                               : "change them, or convert the others with --partial"));
}

/// Warns of profiles that a run will not find.
void warn_of_missing_profiles(const std::vector<convert::ContactCase>& cases,
                              const fs::path& file) {
  std::vector<std::string> names;
  for (const convert::ContactCase& given : cases) {
    if (given.module != 1) continue;
    for (const std::string& name : {given.wheel_rail.rail.name, given.wheel_rail.wheel.name})
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  for (const std::string& name : names)
    if (!fs::exists(file.parent_path() / name))
      warn({fmt::format(
          "the profile {} does not exist; do: put it beside {} before running the cases", name,
          file.string())});
}

convert::Conversion conversion_of(const ConvertRequest& request,
                                  const std::vector<convert::ContactCase>& cases,
                                  const fs::path& directory) {
  const fs::path file(request.file);
  std::vector<int> chosen;
  if (!request.cases.empty())
    chosen = convert::numbers_of(request.cases, static_cast<int>(cases.size()), request.file);
  std::string source = file.filename().string();
  std::replace_if(
      source.begin(), source.end(), [](unsigned char c) { return c < ' '; }, '?');
  return convert::convert_cases(cases, file.stem().string(), source,
                                profile_folder(file, directory), chosen);
}

/// Writes the case files and returns those that `check` accepts; the others are refused.
std::vector<convert::CaseFile> written_cases(const convert::Conversion& conversion,
                                             const fs::path& directory,
                                             const contact::ModelRegistry& models, Written& written,
                                             Refused& refused) {
  std::vector<convert::CaseFile> kept;
  for (convert::CaseFile made : conversion.files) {
    for (const auto& [name, content] : made.attached_files) written.write(name, content);
    written.write(made.name, made.text);
    const auto replace = [&](convert::CaseFile better) {
      made = std::move(better);
      written.remove(directory / made.name);
      written.write(made.name, made.text);
    };
    Verdict verdict = checked(directory / made.name, models);
    for (int body = 0; body < 2 && verdict.repairable; ++body) {
      replace(with_repairs(made, *verdict.repairable));
      verdict = checked(directory / made.name, models);
    }
    if (!verdict.wrong.empty()) {
      add(refused, {verdict.wrong}, made.cases);
      for (const auto& [name, content] : made.attached_files) written.remove(directory / name);
      written.remove(directory / made.name);
      continue;
    }
    if (verdict.cells) replace(with_cells(made, *verdict.cells));
    kept.push_back(std::move(made));
  }
  return kept;
}

void print_files(const std::vector<convert::CaseFile>& files, const fs::path& directory) {
  std::vector<std::string> said;
  for (const convert::CaseFile& made : files) {
    std::cout << fmt::format("{}: {}\n", (directory / made.name).string(), case_words(made.cases));
    for (const std::string& note : made.notes) {
      if (std::find(said.begin(), said.end(), note) != said.end()) continue;
      said.push_back(note);
      std::cout << "  note: " << note << '\n';
    }
  }
}

void convert(const ConvertRequest& request, const contact::ModelRegistry& models) {
  const fs::path file(request.file);
  const std::string text = contact::text_of_file(request.file, request.file, largest_input,
                                                 "name an input file of CONTACT (.inp)");
  const auto cases = convert::read_contact_file(text, request.file);
  const fs::path directory =
      request.directory.empty() ? file.stem().string() + "_cases" : request.directory;
  const convert::Conversion conversion = conversion_of(request, cases, directory);
  Refused refused;
  for (const convert::Refusal& refusal : conversion.refused)
    add(refused, refusal.reasons, {refusal.number});
  Written written(directory);
  const std::vector<convert::CaseFile> kept =
      written_cases(conversion, directory, models, written, refused);
  for (const auto& [reasons, numbers] : refused)
    for (const std::string& reason : reasons)
      std::cerr << fmt::format("{}: no equivalent: {}\n", case_words(numbers), reason);
  if (!refused.empty() && (kept.empty() || !request.partial))
    refuse(request.file, refused, kept.empty());
  written.keep();
  warn_of_missing_profiles(cases, file);
  print_files(kept, directory);
}

}  // namespace

void add_convert(CLI::App& program, Call& call) {
  const auto request = std::make_shared<ConvertRequest>();
  CLI::App* convert = program.add_subcommand(
      "convert", "convert a CONTACT input file (modules 1 and 3) to case files");
  convert->add_option("file", request->file, "input file (.inp)")->required();
  convert->add_option("-o,--output", request->directory,
                      "folder for the case files (default: <name of the file>_cases)");
  convert->add_option("--cases", request->cases,
                      "convert only these cases: numbers and ranges, e.g. 1-5,8 (default: all)");
  convert->add_flag("--partial", request->partial,
                    "skip cases whose physics has no equivalent (default: an error)");
  convert->footer(
      "example: rollfem convert cattaneo.inp\nHow every digit and sign is converted: "
      "docs/coming_from_contact.md");
  convert->callback([request, &call] { app::convert(*request, call.models); });
}

}  // namespace rollfem::app
