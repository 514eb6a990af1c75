// The pool's surface as a sheet of springs that drops fall on.
#pragma once

#include "sheet.h"
#include "springs.h"

namespace water {

class Pond {
 public:
  // stiffness: 1/s^2.
  Pond(Integrator integrator, double stiffness);
  // The heights at any time, seconds: depends on nothing but the time, and costs least when times grow.
  void heightsAt(double time, Heights& out);

 private:
  void start(long long second);
  void drop(long long which);

  Integrator integrator_;
  Springs springs_;
  SpringState state_;
  long long first_ = 0;   // second that the state was flat at
  long long steps_ = -1;  // since then; none yet
};

}  // namespace water
