#include "beam/time/arkode_stepper.h"

#include <arkode/arkode_arkstep.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>

#include <sundials/sundials_context.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "beam/time/arkode_equations.h"

namespace zona::beam {
namespace {

constexpr long max_steps = 50'000'000;

struct FreeVector {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
using Vector = std::unique_ptr<_generic_N_Vector, FreeVector>;

struct FreeSolver {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFreeEmpty(solver); }
};
using LinearSolver = std::unique_ptr<_generic_SUNLinearSolver, FreeSolver>;

struct FreeArkode {
  void operator()(void* memory) const { ARKStepFree(&memory); }
};

Eigen::Map<Eigen::VectorXd> view(N_Vector vector) {
  return {N_VGetArrayPointer(vector), N_VGetLength(vector)};
}

int evaluate_rates(realtype time, N_Vector state, N_Vector rates, void* equations) {
  static_cast<ArkodeEquations*>(equations)->rates(time, view(state), view(rates));
  return 0;
}

SUNLinearSolver_Type matrix_embedded(SUNLinearSolver) {
  return SUNLINEARSOLVER_MATRIX_EMBEDDED;
}

/// Data of the linear solver: the equations, and ARKODE for the current gamma.
struct NewtonContext {
  ArkodeEquations* equations;
  void* arkode;
};

int solve_newton(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, realtype) {
  const auto* context = static_cast<NewtonContext*>(solver->content);
  realtype gamma = 0;
  if (ARKStepGetCurrentGamma(context->arkode, &gamma) != ARK_SUCCESS) return -1;
  context->equations->solve_newton(gamma, view(b), view(x));
  return 0;
}

void keep_message(int, const char*, const char* function, char* message, void* text) {
  *static_cast<std::string*>(text) = fmt::format("{}: {}", function, message);
}

}  // namespace

class ArkodeStepper::Session {
 public:
  Session(const BeamSystem& system, const SupportMotion& motion, const Arkode& options,
          const FrequencySpan& span);

  void advance(double to);
  void kick(double time, double velocity_jump);
  RelativeMotion observed() { return equations_.observed(time_, view(state_.get())); }
  long steps() const;

 private:
  void use_explicit();
  void use_implicit();
  void set_tolerances(const BeamSystem& system, const SupportMotion& motion, const Arkode& options);
  void expect_success(int flag) const;

  ArkodeEquations equations_;
  double time_ = 0;
  sundials::Context context_;
  std::string message_;
  Vector state_, absolute_tolerance_;
  std::unique_ptr<void, FreeArkode> arkode_;
  NewtonContext newton_{};
  LinearSolver solver_;
};

ArkodeStepper::Session::Session(const BeamSystem& system, const SupportMotion& motion,
                                const Arkode& options, const FrequencySpan& span)
    : equations_(system, motion, span),
      state_(N_VNew_Serial(equations_.state_size(), context_)),
      absolute_tolerance_(N_VClone(state_.get())) {
  view(state_.get()).setZero();
  const bool is_explicit = options.method == RungeKutta::explicit_8;
  arkode_.reset(ARKStepCreate(is_explicit ? evaluate_rates : nullptr,
                              is_explicit ? nullptr : evaluate_rates, 0, state_.get(), context_));
  if (!arkode_) throw std::runtime_error("ARKODE: no memory for the integrator");
  expect_success(ARKStepSetErrHandlerFn(arkode_.get(), keep_message, &message_));
  expect_success(ARKStepSetUserData(arkode_.get(), &equations_));
  expect_success(ARKStepSetMaxNumSteps(arkode_.get(), max_steps));
  set_tolerances(system, motion, options);
  is_explicit ? use_explicit() : use_implicit();
}

void ArkodeStepper::Session::use_explicit() {
  expect_success(ARKStepSetTableNum(arkode_.get(), ARKODE_DIRK_NONE, ARKODE_FEHLBERG_13_7_8));
}

void ArkodeStepper::Session::use_implicit() {
  expect_success(ARKStepSetTableNum(arkode_.get(), ARKODE_ESDIRK547L2SA2_7_4_5, ARKODE_ERK_NONE));
  newton_ = {&equations_, arkode_.get()};
  solver_.reset(SUNLinSolNewEmpty(context_));
  if (!solver_) throw std::runtime_error("ARKODE: no memory for the linear solver");
  solver_->content = &newton_;
  solver_->ops->gettype = matrix_embedded;
  solver_->ops->solve = solve_newton;
  expect_success(ARKStepSetLinearSolver(arkode_.get(), solver_.get(), nullptr));
  if (equations_.is_linear()) expect_success(ARKStepSetLinear(arkode_.get(), 0));
}

void ArkodeStepper::Session::set_tolerances(const BeamSystem& system, const SupportMotion& motion,
                                            const Arkode& options) {
  const int size = system.size();
  const double peak = peak_displacement(motion);
  const double rate = peak > 0 ? peak_velocity(motion) / peak : 1;
  auto tolerance = view(absolute_tolerance_.get());
  for (int i = 0; i < size; ++i) {
    const double length = system.rotation[i] ? system.element_length : 1;
    tolerance(i) = options.absolute_tolerance / length;
    tolerance(size + i) = rate * tolerance(i);
    // A slow memory variable is like a displacement, a fast one like a velocity over its rate.
    for (int j = 0; j < equations_.beam().memories(); ++j)
      tolerance((2 + j) * size + i) = tolerance(i) * std::min(1., rate / equations_.beam().rate(j));
  }
  for (int j = 0; j < equations_.beam().memories(); ++j)
    tolerance((2 + equations_.beam().memories()) * size + j) =
        options.absolute_tolerance * std::min(1., rate / equations_.beam().rate(j));
  expect_success(
      ARKStepSVtolerances(arkode_.get(), options.relative_tolerance, absolute_tolerance_.get()));
}

void ArkodeStepper::Session::advance(double to) {
  // Stopping at the sample costs less than dense output of an order-8 method and is as accurate.
  expect_success(ARKStepSetStopTime(arkode_.get(), to));
  expect_success(ARKStepEvolve(arkode_.get(), to, state_.get(), &time_, ARK_NORMAL));
}

void ArkodeStepper::Session::kick(double time, double velocity_jump) {
  time_ = time;
  equations_.kick(velocity_jump, view(state_.get()));
  expect_success(ARKStepReset(arkode_.get(), time, state_.get()));
}

long ArkodeStepper::Session::steps() const {
  long steps = 0;
  expect_success(ARKStepGetNumSteps(arkode_.get(), &steps));
  return steps;
}

void ArkodeStepper::Session::expect_success(int flag) const {
  if (flag >= 0) return;
  throw std::runtime_error(fmt::format(
      "ARKODE stopped at t = {} s with code {} ({}); loosen the tolerances or use newmark", time_,
      flag, message_));
}

ArkodeStepper::ArkodeStepper(const BeamSystem& system, const SupportMotion& motion,
                             const Arkode& options, const FrequencySpan& span)
    : session_(std::make_unique<Session>(system, motion, options, span)) {}

ArkodeStepper::~ArkodeStepper() = default;

void ArkodeStepper::advance(double, double to) {
  session_->advance(to);
}
void ArkodeStepper::kick(double time, double jump) {
  session_->kick(time, jump);
}
RelativeMotion ArkodeStepper::observed() const {
  return session_->observed();
}
long ArkodeStepper::steps() const {
  return session_->steps();
}

}  // namespace zona::beam
