// SPDX-License-Identifier: LGPL-2.1-or-later
// Results as bytes and back, for the processes of a pool: bit for bit, by the records of
// checkpoints.
#include "base/errors.hpp"
#include "bindings/python/bindings.hpp"
#include "models/program/provenance.hpp"
#include "result/record.hpp"

namespace rollfem::python {

namespace {

using contact::Record;

/// All but the case.
void exchange(Record& record, Result& result) {
  record.values(result.provenance, result.verdict, result.models, result.pairs, result.wheelset,
                result.rigid_row);
}

std::string program() {
  return modelling::version() + ' ' + modelling::commit();
}

}  // namespace

py::tuple packed(const Result& result) {
  Result copy = result;
  Record record;
  exchange(record, copy);
  return py::make_tuple(program(), copy.input.text, copy.input.file, copy.input.models,
                        py::bytes(record.bytes()));
}

Shared unpacked(const py::tuple& state) {
  if (state[0].cast<std::string>() != program())
    throw InputError("a pickled result belongs to another version of rollfem (" +
                     state[0].cast<std::string>() + "); do: unpickle it there, and write it");
  auto result = std::make_shared<Result>();
  result->input = parse_case(state[1].cast<std::string>(), state[2].cast<std::string>());
  result->input.models = state[3].cast<std::vector<std::string>>();
  Record record(state[4].cast<std::string>());
  exchange(record, *result);
  return result;
}

}  // namespace rollfem::python
