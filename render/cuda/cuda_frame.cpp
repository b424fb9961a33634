#include "render/cuda/cuda_frame.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace suffuse {

namespace {

using cuda::Device;
using cuda::Fault;

Result<void> resultOf(const Fault &fault)
{
    return fault ? Result<void>(Error{QString::fromStdString(fault.what)}) : Result<void>();
}

/// Every copy costs a call, so many rectangles are copied as the one that holds them all. That never shows anything
/// unfinished, since both pictures are whole whenever they are copied.
std::vector<PixelRect> fewRects(const std::vector<PixelRect> &rects)
{
    constexpr std::size_t few = 4;
    if (rects.size() <= few)
        return rects;
    int left = rects[0].x, top = rects[0].y, right = left, bottom = top;
    for (const PixelRect &r : rects) {
        left = std::min(left, r.x);
        top = std::min(top, r.y);
        right = std::max(right, r.x + r.width);
        bottom = std::max(bottom, r.y + r.height);
    }
    return {PixelRect{left, top, right - left, bottom - top}};
}

// Rectangles are handed to the device as they are.
static_assert(sizeof(PixelRect) == sizeof(int[4]) && std::is_standard_layout_v<PixelRect>);

const int (*asArrays(const std::vector<PixelRect> &rects))[4]
{
    return reinterpret_cast<const int(*)[4]>(rects.data());
}

class CudaTextureLink : public TextureLink {
public:
    CudaTextureLink(std::shared_ptr<Device> device, std::unique_ptr<cuda::GlTexture> texture)
        : m_device(std::move(device)), m_texture(std::move(texture))
    {}
    cuda::GlTexture &texture() { return *m_texture; }

private:
    std::shared_ptr<Device> m_device; ///< It must outlive the texture.
    std::unique_ptr<cuda::GlTexture> m_texture;
};

class DevicePictures : public CudaFrame {
public:
    DevicePictures(std::shared_ptr<Device> device, int width, int height)
        : m_device(std::move(device)), m_width(width), m_height(height)
    {}
    ~DevicePictures() override
    {
        for (std::uint32_t *picture : {m_work, m_shown})
            if (picture)
                m_device->release(picture);
    }

    Fault allocate()
    {
        const std::size_t bytes = std::size_t(m_width) * m_height * sizeof(std::uint32_t);
        for (std::uint32_t **picture : {&m_work, &m_shown}) {
            void *memory = nullptr;
            if (Fault fault = m_device->allocate(bytes, &memory))
                return fault;
            *picture = static_cast<std::uint32_t *>(memory);
            if (Fault fault = m_device->clear(memory, bytes))
                return fault;
        }
        return {};
    }

    std::uint32_t *picture() override { return m_work; }
    int width() const override { return m_width; }
    int height() const override { return m_height; }

    Result<void> publish(const std::vector<PixelRect> &rects) override
    {
        if (rects.empty())
            return {};
        const std::vector<PixelRect> few = fewRects(rects);
        if (Fault fault = m_device->copyRects(m_shown, m_work, m_width, asArrays(few), int(few.size())))
            return resultOf(fault);
        return resultOf(m_device->finish(nullptr));
    }

    Result<std::unique_ptr<TextureLink>> link(unsigned texture) override
    {
        Fault fault;
        std::unique_ptr<cuda::GlTexture> registered = m_device->registerTexture(texture, fault);
        if (!registered)
            return Error{QString::fromStdString(fault.what)};
        return std::unique_ptr<TextureLink>(std::make_unique<CudaTextureLink>(m_device, std::move(registered)));
    }

    Result<void> copyTo(TextureLink &texture, const std::vector<PixelRect> &rects) override
    {
        if (rects.empty())
            return {};
        const std::vector<PixelRect> few = fewRects(rects);
        cuda::GlTexture &to = static_cast<CudaTextureLink &>(texture).texture();
        return resultOf(to.copyFrom(m_shown, m_width, asArrays(few), int(few.size())));
    }

private:
    std::shared_ptr<Device> m_device;
    int m_width;
    int m_height;
    std::uint32_t *m_work = nullptr;
    std::uint32_t *m_shown = nullptr;
};

} // namespace

std::shared_ptr<CudaFrame> makeCudaFrame(std::shared_ptr<cuda::Device> device, int width, int height, std::string &why)
{
    auto frame = std::make_shared<DevicePictures>(std::move(device), width, height);
    if (Fault fault = frame->allocate()) {
        why = fault.what;
        return nullptr;
    }
    return frame;
}

} // namespace suffuse
