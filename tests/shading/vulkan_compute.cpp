#include "shading/vulkan_compute.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace gp::test {
namespace {

void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) {
        throw std::runtime_error(std::string(what) + " failed with VkResult " +
                                 std::to_string(static_cast<int>(result)));
    }
}

uint32_t computeFamily(VkPhysicalDevice device) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    for (uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) {
            return i;
        }
    }
    return UINT32_MAX;
}

// Host-visible and coherent memory: the specification promises one such type for every buffer.
uint32_t hostMemoryType(VkPhysicalDevice device, uint32_t allowed) {
    VkPhysicalDeviceMemoryProperties properties;
    vkGetPhysicalDeviceMemoryProperties(device, &properties);
    constexpr VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    for (uint32_t i = 0; i < properties.memoryTypeCount; ++i) {
        const bool fits = (allowed & (1u << i)) != 0;
        if (fits && (properties.memoryTypes[i].propertyFlags & wanted) == wanted) {
            return i;
        }
    }
    throw std::runtime_error("the Vulkan device has no host-visible memory");
}

// What the shader is told: words an invocation, invocations, and where the table is.
using Constants = std::array<uint32_t, 5>;

}  // namespace

struct VulkanCompute::Buffer {
    Buffer(const VulkanCompute& vulkan, size_t words) : device(vulkan.device_) {
        VkBufferCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        info.size = size = words * sizeof(uint32_t);
        info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
        check(vkCreateBuffer(device, &info, nullptr, &handle), "vkCreateBuffer");
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(device, handle, &needs);
        VkMemoryAllocateInfo allocation{};
        allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        allocation.allocationSize = needs.size;
        allocation.memoryTypeIndex = hostMemoryType(vulkan.physical_, needs.memoryTypeBits);
        VkMemoryAllocateFlagsInfo flags{};
        flags.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO;
        flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
        allocation.pNext = &flags;
        check(vkAllocateMemory(device, &allocation, nullptr, &memory), "vkAllocateMemory");
        check(vkBindBufferMemory(device, handle, memory, 0), "vkBindBufferMemory");
        check(vkMapMemory(device, memory, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
    }
    ~Buffer() {
        vkDestroyBuffer(device, handle, nullptr);
        vkFreeMemory(device, memory, nullptr);
    }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    VkDeviceAddress address() const {
        VkBufferDeviceAddressInfo info{};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO;
        info.buffer = handle;
        return vkGetBufferDeviceAddress(device, &info);
    }

    VkDevice device;
    VkDeviceSize size = 0;
    VkBuffer handle = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    void* mapped = nullptr;
};

struct VulkanCompute::Pipeline {
    Pipeline(VkDevice owner, const Job& job) : device(owner) {
        createLayout();
        VkShaderModuleCreateInfo code{};
        code.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        code.codeSize = job.spirv->size() * sizeof(uint32_t);
        code.pCode = job.spirv->data();
        check(vkCreateShaderModule(device, &code, nullptr, &module), "vkCreateShaderModule");
        const VkSpecializationMapEntry entry{0, 0, sizeof(uint32_t)};
        const VkSpecializationInfo constants{1, &entry, sizeof(uint32_t), &job.function};
        VkComputePipelineCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
        info.layout = layout;
        info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        info.stage.module = module;
        info.stage.pName = "main";
        info.stage.pSpecializationInfo = &constants;
        check(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &handle),
              "vkCreateComputePipelines");
    }
    ~Pipeline() {
        vkDestroyPipeline(device, handle, nullptr);
        vkDestroyShaderModule(device, module, nullptr);
        vkDestroyPipelineLayout(device, layout, nullptr);
        vkDestroyDescriptorPool(device, pool, nullptr);
        vkDestroyDescriptorSetLayout(device, setLayout, nullptr);
    }
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    void createLayout() {
        std::array<VkDescriptorSetLayoutBinding, 2> bindings{};
        for (uint32_t i = 0; i < bindings.size(); ++i) {
            bindings[i].binding = i;
            bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            bindings[i].descriptorCount = 1;
            bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
        }
        VkDescriptorSetLayoutCreateInfo setInfo{};
        setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        setInfo.bindingCount = 2;
        setInfo.pBindings = bindings.data();
        check(vkCreateDescriptorSetLayout(device, &setInfo, nullptr, &setLayout), "set layout");
        const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(Constants)};
        VkPipelineLayoutCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        info.setLayoutCount = 1;
        info.pSetLayouts = &setLayout;
        info.pushConstantRangeCount = 1;
        info.pPushConstantRanges = &push;
        check(vkCreatePipelineLayout(device, &info, nullptr, &layout), "vkCreatePipelineLayout");
    }

    void bind(const Buffer& input, const Buffer& output) {
        const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
        VkDescriptorPoolCreateInfo poolInfo{};
        poolInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
        poolInfo.maxSets = 1;
        poolInfo.poolSizeCount = 1;
        poolInfo.pPoolSizes = &size;
        check(vkCreateDescriptorPool(device, &poolInfo, nullptr, &pool), "descriptor pool");
        VkDescriptorSetAllocateInfo allocation{};
        allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
        allocation.descriptorPool = pool;
        allocation.descriptorSetCount = 1;
        allocation.pSetLayouts = &setLayout;
        check(vkAllocateDescriptorSets(device, &allocation, &set), "vkAllocateDescriptorSets");
        const std::array<VkDescriptorBufferInfo, 2> infos{
            VkDescriptorBufferInfo{input.handle, 0, VK_WHOLE_SIZE},
            VkDescriptorBufferInfo{output.handle, 0, VK_WHOLE_SIZE}};
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set;
        write.descriptorCount = 2;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = infos.data();
        vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
    }

    VkDevice device;
    VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkShaderModule module = VK_NULL_HANDLE;
    VkPipeline handle = VK_NULL_HANDLE;
};

std::unique_ptr<VulkanCompute> VulkanCompute::create() {
    std::unique_ptr<VulkanCompute> vulkan(new VulkanCompute);
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_2;  // for addresses of buffers
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    check(vkCreateInstance(&info, nullptr, &vulkan->instance_), "vkCreateInstance");
    vulkan->chooseDevice();
    vulkan->createDevice();
    return vulkan;
}

void VulkanCompute::chooseDevice() {
    uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "enumerating devices");
    const char* wanted = std::getenv("GP_VULKAN_DEVICE");
    for (VkPhysicalDevice device : devices) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(device, &properties);
        const std::string name = properties.deviceName;
        const bool software = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
        const bool chosen = wanted != nullptr ? name.find(wanted) != std::string::npos : software;
        if (computeFamily(device) != UINT32_MAX && (physical_ == VK_NULL_HANDLE || chosen)) {
            physical_ = device;
            name_ = name;
            if (chosen) {
                break;
            }
        }
    }
    if (physical_ == VK_NULL_HANDLE) {
        throw std::runtime_error("no Vulkan device that computes; install mesa-vulkan-drivers");
    }
    if (wanted != nullptr && name_.find(wanted) == std::string::npos) {
        throw std::runtime_error(std::string("no Vulkan device is called ") + wanted);
    }
}

void VulkanCompute::createDevice() {
    family_ = computeFamily(physical_);
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = family_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    // Every shader that includes shading/lang.glsl declares that it may read by addresses.
    VkPhysicalDeviceBufferDeviceAddressFeatures addresses{};
    addresses.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES;
    addresses.bufferDeviceAddress = VK_TRUE;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &addresses;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    check(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
    vkGetDeviceQueue(device_, family_, 0, &queue_);
    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.queueFamilyIndex = family_;
    check(vkCreateCommandPool(device_, &pool, nullptr, &commands_), "vkCreateCommandPool");
}

VulkanCompute::~VulkanCompute() {
    if (device_ != VK_NULL_HANDLE) {
        vkDestroyCommandPool(device_, commands_, nullptr);
        vkDestroyDevice(device_, nullptr);
    }
    if (instance_ != VK_NULL_HANDLE) {
        vkDestroyInstance(instance_, nullptr);
    }
}

std::vector<uint32_t> VulkanCompute::run(const Job& job) const {
    Buffer input(*this, job.input->size());
    Buffer output(*this, size_t(job.outputStride) * job.count);
    std::memcpy(input.mapped, job.input->data(), job.input->size() * sizeof(uint32_t));
    std::memset(output.mapped, 0xFF, output.size);  // NaN: an output that is not written shows
    Buffer table(*this, std::max<size_t>(job.table.size() / sizeof(uint32_t), 1));
    std::memcpy(table.mapped, job.table.data(), job.table.size_bytes());
    Pipeline pipeline(device_, job);
    pipeline.bind(input, output);
    submit(pipeline, job, table);
    std::vector<uint32_t> result(size_t(job.outputStride) * job.count);
    std::memcpy(result.data(), output.mapped, result.size() * sizeof(uint32_t));
    return result;
}

void VulkanCompute::submit(const Pipeline& pipeline, const Job& job, const Buffer& table) const {
    VkCommandBufferAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocation.commandPool = commands_;
    allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocation.commandBufferCount = 1;
    VkCommandBuffer buffer = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device_, &allocation, &buffer), "vkAllocateCommandBuffers");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    check(vkBeginCommandBuffer(buffer, &begin), "vkBeginCommandBuffer");
    vkCmdBindPipeline(buffer, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle);
    vkCmdBindDescriptorSets(buffer, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.layout, 0, 1,
                            &pipeline.set, 0, nullptr);
    const VkDeviceAddress at = job.table.empty() ? 0 : table.address();
    const Constants push{job.inputStride, job.outputStride, job.count, uint32_t(at),
                         uint32_t(at >> 32u)};
    vkCmdPushConstants(buffer, pipeline.layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(push),
                       push.data());
    vkCmdDispatch(buffer, (job.count + groupSize - 1) / groupSize, 1, 1);
    VkMemoryBarrier toHost{};
    toHost.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    toHost.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    toHost.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(buffer, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                         0, 1, &toHost, 0, nullptr, 0, nullptr);
    check(vkEndCommandBuffer(buffer), "vkEndCommandBuffer");
    VkSubmitInfo submission{};
    submission.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submission.commandBufferCount = 1;
    submission.pCommandBuffers = &buffer;
    check(vkQueueSubmit(queue_, 1, &submission, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
    vkFreeCommandBuffers(device_, commands_, 1, &buffer);
}

}  // namespace gp::test
