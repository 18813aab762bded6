// The least of Vulkan that runs a compute shader over arrays: what the differential tests need to
// compare the shading functions of the two compilers. Not a piece of the renderer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <vulkan/vulkan.h>

namespace gp::test {

class VulkanCompute {
public:
    // The device of the tests: a software one where there is any, for it gives every machine the
    // same numbers; GP_VULKAN_DEVICE (a part of a device's name) asks for another. Throws
    // std::runtime_error that says what is missing.
    static std::unique_ptr<VulkanCompute> create();
    ~VulkanCompute();
    VulkanCompute(const VulkanCompute&) = delete;
    VulkanCompute& operator=(const VulkanCompute&) = delete;

    const std::string& deviceName() const { return name_; }

    struct Job {
        const std::vector<uint32_t>* spirv = nullptr;
        uint32_t function = 0;                        // specialization constant 0
        const std::vector<uint32_t>* input = nullptr; // binding 0; the output is binding 1
        uint32_t inputStride = 0;                     // words an invocation: push constants
        uint32_t outputStride = 0;
        uint32_t count = 0;                           // invocations; the shader checks the bound
        std::span<const std::byte> table;  // words; their address follows the other constants
    };
    std::vector<uint32_t> run(const Job& job) const;

    static constexpr uint32_t groupSize = 64;

private:
    struct Buffer;
    struct Pipeline;
    VulkanCompute() = default;
    void chooseDevice();
    void createDevice();
    void submit(const Pipeline& pipeline, const Job& job, const Buffer& table) const;

    VkInstance instance_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    VkCommandPool commands_ = VK_NULL_HANDLE;
    uint32_t family_ = 0;
    std::string name_;
};

}  // namespace gp::test
