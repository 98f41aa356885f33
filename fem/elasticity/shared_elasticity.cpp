// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/shared_elasticity.hpp"

#include "contact/result/record.hpp"

#include <utility>

namespace rollfem::fem {

namespace {

enum class Action { prepare, respond, complete };

/// An order with its data.
struct Task {
  Action action = Action::prepare;
  contact::SurfaceField traction;
  // Data for completing a load point.
  long number = 0;
  double normal_force = 0.0;

  void exchange(contact::Record& record) {
    int code = static_cast<int>(action);
    record.values(code, traction, number, normal_force);
    action = static_cast<Action>(code);
  }
  FirstProcess::Order order() {
    contact::Record record;
    exchange(record);
    return record.bytes();
  }
};

}  // namespace

SharedElasticity::SharedElasticity(std::unique_ptr<contact::Elasticity> own, FirstProcess& first)
    : own_(std::move(own)), first_(first) {}

void SharedElasticity::obey(const FirstProcess::Order& order) {
  Task task;
  contact::Record record(order);
  task.exchange(record);
  if (task.action == Action::prepare) own_->prepare();
  if (task.action == Action::respond) own_->compliance().respond(task.traction);
  if (task.action != Action::complete) return;
  contact::PointResult point;
  point.normal_force = task.normal_force;
  point.fields.traction = std::move(task.traction);
  own_->complete(static_cast<std::size_t>(task.number), point);
}

void SharedElasticity::prepare() {
  first_.call(Task{}.order(), [&] { own_->prepare(); });
}

contact::Response SharedElasticity::Together::respond(const contact::SurfaceField& traction) const {
  contact::Response response;
  all_.first_.call(Task{Action::respond, traction}.order(),
                   [&] { response = all_.own_->compliance().respond(traction); });
  return response;
}

void SharedElasticity::complete(std::size_t k, contact::PointResult& point) {
  first_.call(
      Task{Action::complete, point.fields.traction, static_cast<long>(k), point.normal_force}
          .order(),
      [&] { own_->complete(k, point); });
}

}  // namespace rollfem::fem
