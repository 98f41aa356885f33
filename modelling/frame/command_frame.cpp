// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/frame/command_frame.hpp"

#include "base/errors.hpp"
#include "modelling/frame/interruption.hpp"
#include "modelling/frame/parts.hpp"
#include "modelling/program/provenance.hpp"
#include "modelling/registry.hpp"
#include "modelling/solving/auto_model.hpp"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <iostream>

namespace rollfem::modelling {

namespace fs = std::filesystem;

namespace {

volatile std::sig_atomic_t held_signal = 0;

/// Delays Ctrl-C and similar signals while results are written, so that a folder is complete or
/// absent. Uses handlers instead of a mask, because threads of BLAS and MPI would receive a signal
/// masked here.
class SignalsHeld {
 public:
  SignalsHeld() {
    struct sigaction hold {};
    hold.sa_handler = [](int signal) { held_signal = signal; };
    hold.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < before_.size(); ++i) sigaction(signals[i], &hold, &before_[i]);
  }
  ~SignalsHeld() {
    for (std::size_t i = 0; i < before_.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
    if (held_signal != 0) static_cast<void>(std::raise(held_signal));
  }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, 3> before_{};
};

void print_warning(const std::string& warning) {
  std::cerr << "warning: " << warning << '\n';
}

}  // namespace

CommandFrame::CommandFrame(const Computing& request, std::vector<std::string> models)
    : request_(request),
      models_(std::move(models)),
      first_(!request.own.whole() || processes().first()),
      parallel_(request.own.whole() && any_parallel(request.known, models_)),
      processes_(request.own.whole() ? processes().count : 1),
      display_(request.quiet || !first_ ? ProgressDisplay::Mode::silent
                                        : ProgressDisplay::mode_of_stderr()),
      progress_([this](const contact::ProgressEvent& event) { display_.show(event); }) {}

std::string CommandFrame::program() const {
  return fmt::format("{} ({})", version(), commit());
}

CommandFrame::~CommandFrame() {
  remove_nothing_when_interrupted();  // files with these names may belong to another process from
                                      // here on
}

void CommandFrame::say(const std::string& line) {
  display_.clear();
  if (first_ && !request_.quiet) std::cerr << line << '\n';
}

result::Provenance CommandFrame::provenance() const {
  result::Provenance made = provenance_of(request_.known, request_.command);
  made.processes = parallel_ ? processes_ : 1;
  return made;
}

void CommandFrame::own(const fs::path& directory) {
  if (!first_) return;
  owned_.push_back(std::make_unique<result::FolderOwner>(part_directory(directory, request_.own),
                                                         request_.command));
  for (const fs::path& made : owned_.back()->made()) remove_when_interrupted(made.string());
}

/// Prepares the message about what an interruption leaves behind.
void CommandFrame::set_interrupt_message() const {
  if (!first_) return;
  if (!kept_ || kept_->kept() == 0)
    say_when_interrupted("no finished work was stored and no result written");
  else
    say_when_interrupted(fmt::format(
        "{} finished solutions are kept in {}; the same command with --resume continues from them",
        kept_->kept(), kept_->folder().string()));
}

result::CheckpointFolder* CommandFrame::keep_in(const fs::path& directory,
                                                const contact::Case& input) {
  if (!first_) return nullptr;
  kept_.reset();  // releases the lock before the next one is taken
  kept_ = std::make_unique<result::CheckpointFolder>(part_directory(directory, request_.own), input,
                                                     program(), request_.resume, print_warning);
  merge_parts(directory, input);
  kept_->when_stored([this] { set_interrupt_message(); });
  set_interrupt_message();
  const std::string folder = fs::path(kept_->folder()).lexically_proximate(fs::current_path());
  const auto found = kept_->found();
  if (found > 0 && !request_.resume)
    std::cerr << fmt::format(
        "warning: {} holds {} solutions of an earlier, unfinished run; --resume would continue "
        "from them, but this run starts over; until it is done they are kept in {}\n",
        folder, found,
        fs::path(kept_->set_aside()).lexically_proximate(fs::current_path()).string());
  else if (found > 0)
    say(fmt::format("resume: {} solutions of an earlier run in {}", found, folder));
  else if (request_.resume)
    say("resume: no load points of an earlier run found; everything is computed");
  return kept_.get();
}

/// Throws contact::InputError that names the missing parts.
void CommandFrame::merge_parts(const fs::path& directory, const contact::Case& input) {
  std::string missing;
  for (int part = 0; part < request_.merge; ++part) {
    const std::string folder = part_directory(directory, {part, request_.merge});
    if (result::CheckpointFolder::is_marked(folder, part_done))
      kept_->also_find_in(std::make_unique<result::CheckpointFolder>(folder, input, program(), true,
                                                                     print_warning));
    else
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", part + 1);
  }
  if (!missing.empty())
    throw contact::InputError(
        fmt::format("--merge {}: parts missing beside {}: {}; do: run the same command with --part "
                    "K/{} for each, then merge",
                    request_.merge, directory.string(), missing, request_.merge));
}

bool CommandFrame::ends_part() {
  if (request_.own.whole()) return false;
  const int part = request_.own.part + 1, of = request_.own.of;
  if (kept_->untouched())
    print_warning(fmt::format(
        "part {} of {} is empty: the work of this case divides into fewer parts", part, of));
  if (!kept_->mark(part_done))
    throw contact::OutputError(fmt::format(
        "part {} of {} was solved but could not be stored; do: free some space or choose another "
        "disk with -o, and repeat the command",
        part, of));
  say(fmt::format(
      "part {} of {} is done; after all parts, the same command with --merge {} writes the result",
      part, of, of));
  return true;
}

void CommandFrame::forget_kept() {
  if (kept_) kept_->remove();
  kept_.reset();
}

void CommandFrame::print_kept(const std::string& kept) const {
  if (!kept_ || request_.quiet || !kept_->holds_records()) return;
  std::cerr << fmt::format(
      "finished {} are kept; the same command with --resume continues from them: {}\n", kept,
      kept_->folder().string());
}

void CommandFrame::compute(const std::string& asked_by, const std::string& kept,
                           const std::function<void(const Solving&)>& body) {
  check_built(request_.known, models_, asked_by);
  set_interrupt_message();
  Solving how;
  const auto start = [&] { how.session = &parallel_session(asked_by); };
  // A choice may end without finite elements, whose library takes longer to load than half-spaces
  // take to solve. With several processes the library is needed for their agreement.
  if (parallel_ && (processes_ > 1 || !any_choice(request_.known, models_))) start();
  try {
    how.need_session = start;
    how.models = &request_.known;
    how.progress = progress_;
    how.first = first_;
    how.together = processes_ == 1;
    body(how);
    display_.clear();
  } catch (...) {
    display_.clear();
    print_kept(kept);
    throw;
  }
}

void store_results(const std::string& directory, const result::RunRecord& record) {
  const SignalsHeld held;
  result::write_results(directory, record);
  say_when_interrupted("the results were written to " + directory +
                       ", but not completely; repeat the same command");
}

void refuse_other_result(const fs::path& directory, const std::string& own) {
  for (const char* other : {"summary.json", "compare.json", "study.json", "table.h5"})
    if (other != own && fs::exists(directory / other))
      throw contact::InputError(
          fmt::format("{} holds the result of another command ({}); do: name another folder with "
                      "-o",
                      directory.string(), other));
}

}  // namespace rollfem::modelling
