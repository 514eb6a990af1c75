// A process that ends while devices are there: their work is done, and none of their threads does anything,
// before the static objects of the driver and of the compiler inside it are destroyed.
#pragma once

namespace anteroom::vulkan {

class VulkanDevice;

// `device` has been made. Forget it before it is destroyed.
void finishAtExit(VulkanDevice& device);
void forgetAtExit(VulkanDevice& device);

// The calling thread has given a device work. exit() waits for it before it does anything else, when this
// thread calls it: what the driver's compiler makes meanwhile would be destroyed first.
void noteWorker();

}  // namespace anteroom::vulkan
