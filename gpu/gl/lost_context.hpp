#pragma once

namespace autostereo::gpu::gl {

/// Once the GPU was reset, calls do nothing and pictures stay as they are: throws PanelLost then,
/// where the driver tells. On the context's thread.
void throwIfReset();

} // namespace autostereo::gpu::gl
