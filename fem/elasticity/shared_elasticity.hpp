// SPDX-License-Identifier: LGPL-2.1-or-later
// The elasticity of several processes for a contact problem solved by the first one: all processes
// take part in its evaluations.
#pragma once

#include "contact/solve/contact_run.hpp"
#include "fem/linear/first_process.hpp"

#include <memory>

namespace rollfem::fem {

class SharedElasticity : public contact::Elasticity {
 public:
  /// `own`: the elasticity of every process, whose prepare(), compliance() and complete() are
  /// collective.
  SharedElasticity(std::unique_ptr<contact::Elasticity> own, FirstProcess& first);

  /// On other processes: executes an order of the first one (FirstProcess::run).
  void obey(const FirstProcess::Order& order);

  void prepare() override;
  const contact::Compliance& compliance() const override { return compliance_; }
  void complete(std::size_t k, contact::PointResult& point) override;
  const contact::SolvableCompliance& standin() const override { return own_->standin(); }
  const contact::Compliance* coupled_standin() const override { return own_->coupled_standin(); }
  contact::Field extra_distance() const override { return own_->extra_distance(); }
  contact::TangentialField extra_slip() const override { return own_->extra_slip(); }
  Eigen::Vector2d rolling_stiffness(const contact::PatchSize& patch) const override {
    return own_->rolling_stiffness(patch);
  }
  Eigen::Vector2d shift_stiffness(const contact::PatchSize& patch) const override {
    return own_->shift_stiffness(patch);
  }

 private:
  class Together : public contact::Compliance {
   public:
    explicit Together(const SharedElasticity& all) : all_(all) {}
    const contact::ContactGrid& grid() const override { return all_.own_->compliance().grid(); }
    contact::SurfaceField apply(const contact::SurfaceField& traction) const override {
      return respond(traction).displacement;
    }
    contact::Response respond(const contact::SurfaceField& traction) const override;

   private:
    const SharedElasticity& all_;
  };

  std::unique_ptr<contact::Elasticity> own_;
  FirstProcess& first_;
  Together compliance_{*this};
};

}  // namespace rollfem::fem
