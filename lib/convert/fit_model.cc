// SPDX-License-Identifier: BSD-3-Clause
// The one place where the fit is instantiated for the models of the list.
#include "fit_model.h"

#include "fit.h"

namespace fca::internal {

std::optional<FittedModel> fit_model(std::string_view id, std::span<const Correspondence> samples, const LensCentre& centre,
                                     std::span<const ParameterRange> ranges) {
  std::optional<FittedModel> result;
  ModelList::for_each([&]<CameraModelType M>() {
    if (M::kId != id) return;
    std::optional<Fit<M>> fit = Fitter<M>(samples, ranges).fit(centre);
    if (!fit) return;
    result =
        FittedModel{Intrinsics<M>{fit->parameters}, fit->rms_px, fit->iterations, fit->reaches_all, std::move(fit->at_bound)};
  });
  return result;
}

}  // namespace fca::internal
