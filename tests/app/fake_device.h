// A renderer whose pictures stay on a device that is none: they lie in memory, and can fail in every way.
#pragma once

#include "render/backends.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

namespace suffuse {

/// What a test sets and sees of the device, from any thread.
struct FakeDevice {
    std::atomic<bool> linksFail = false;
    std::atomic<int> copiesUntilFailure = -1;    ///< -1: none fails
    std::atomic<int> publishesUntilFailure = -1; ///< -1: none fails
    std::atomic<bool> lost = false;              ///< the CPU goes on, and a notice says so

    std::atomic<int> links = 0; ///< texture links alive
    std::atomic<int> linksMade = 0;
    std::atomic<int> badLinkEnds = 0; ///< without the context, or after the texture
    std::atomic<int> copies = 0;
    std::atomic<int> frames = 0;       ///< device frames alive
    std::atomic<int> deviceFrames = 0; ///< renders that stayed on the device
    std::mutex mutex;
    std::thread::id renderThread;   ///< where the renderer was made
    std::atomic<int> strayEnds = 0; ///< renderers and frames that ended on another thread

    /// Counts down to a failure.
    static bool fails(std::atomic<int> &countdown) { return countdown >= 0 && countdown-- == 0; }
    void endHere()
    {
        const std::lock_guard lock(mutex);
        if (renderThread != std::this_thread::get_id())
            ++strayEnds;
    }
};

/// Writes as a device does: raw pixels into the texture, whatever else is bound.
class FakeLink : public TextureLink {
public:
    FakeLink(FakeDevice &device, GLuint texture)
        : m_device(device), m_texture(texture), m_group(QOpenGLContext::currentContext()->shareGroup())
    {
        ++m_device.links;
        ++m_device.linksMade;
    }
    ~FakeLink() override
    {
        --m_device.links;
        QOpenGLContext *context = QOpenGLContext::currentContext();
        if (!context || context->shareGroup() != m_group || !context->functions()->glIsTexture(m_texture))
            ++m_device.badLinkEnds;
    }
    GLuint texture() const { return m_texture; }

private:
    FakeDevice &m_device;
    GLuint m_texture;
    QOpenGLContextGroup *m_group;
};

class FakeDeviceFrame : public DeviceFrame {
public:
    FakeDeviceFrame(FakeDevice &device, int width, int height) : m_device(device)
    {
        work.resize(width, height);
        m_shown.resize(width, height);
        ++m_device.frames;
    }
    ~FakeDeviceFrame() override
    {
        --m_device.frames;
        m_device.endHere();
    }

    int width() const override { return work.width; }
    int height() const override { return work.height; }
    Result<void> publish(const std::vector<PixelRect> &rects) override
    {
        if (FakeDevice::fails(m_device.publishesUntilFailure))
            return Error{QStringLiteral("the device lost its picture")};
        for (const PixelRect &r : rects)
            m_shown.storeArgb(r, work.argb.data() + std::size_t(r.y) * work.width + r.x, work.width);
        return {};
    }
    Result<std::unique_ptr<TextureLink>> link(unsigned texture) override
    {
        if (m_device.linksFail)
            return Error{QStringLiteral("another device draws this OpenGL context")};
        return std::unique_ptr<TextureLink>(std::make_unique<FakeLink>(m_device, texture));
    }
    Result<void> copyTo(TextureLink &link, const std::vector<PixelRect> &rects) override
    {
        if (FakeDevice::fails(m_device.copiesUntilFailure))
            return Error{QStringLiteral("the texture is gone")};
        QOpenGLFunctions &gl = *QOpenGLContext::currentContext()->functions();
        gl.glBindTexture(GL_TEXTURE_2D, static_cast<FakeLink &>(link).texture());
        gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        for (const PixelRect &r : rects)
            for (int y = r.y; y < r.y + r.height; ++y)
                gl.glTexSubImage2D(GL_TEXTURE_2D, 0, r.x, y, r.width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                                   m_shown.argb.data() + std::size_t(y) * m_shown.width + r.x);
        ++m_device.copies;
        return {};
    }
    const Picture8 &shown() const { return m_shown; }

    Picture8 work; ///< rendered here

private:
    FakeDevice &m_device;
    Picture8 m_shown;
};

/// The CPU's pixels, by way of the device.
class FakeDeviceRenderer : public Renderer {
public:
    FakeDeviceRenderer(FakeDevice &device, std::unique_ptr<Renderer> cpu) : m_device(device), m_cpu(std::move(cpu))
    {
        const std::lock_guard lock(m_device.mutex);
        m_device.renderThread = std::this_thread::get_id();
    }
    ~FakeDeviceRenderer() override { m_device.endHere(); }

    Backend backend() const override { return m_device.lost ? Backend::Cpu : Backend::Cuda; }
    QString deviceName() const override { return m_device.lost ? m_cpu->deviceName() : QStringLiteral("Fake 1"); }
    QString notice() const override { return m_device.lost ? QStringLiteral("CUDA stopped: it is lost") : QString(); }
    void invalidate() override { m_cpu->invalidate(); }

    Result<RenderStats> render(const RenderRequest &request, Target &target, const std::atomic<bool> *cancel) override
    {
        const bool onDevice = target.takesDeviceFrames() && !m_device.lost;
        if (onDevice != m_onDevice) // a picture is only where it was drawn
            m_cpu->invalidate();
        m_onDevice = onDevice;
        if (!onDevice)
            return m_cpu->render(request, target, cancel);
        const View &view = request.view;
        if (!m_frame || m_frame->width() != view.width || m_frame->height() != view.height)
            m_frame = std::make_shared<FakeDeviceFrame>(m_device, view.width, view.height);
        Result<RenderStats> stats = m_cpu->render(request, m_frame->work, cancel);
        if (stats)
            stats->frame = m_frame;
        ++m_device.deviceFrames;
        return stats;
    }

private:
    FakeDevice &m_device;
    std::unique_ptr<Renderer> m_cpu;
    std::shared_ptr<FakeDeviceFrame> m_frame;
    bool m_onDevice = false;
};

/// Makes renderers on the device.
inline MakeRenderer makerOn(FakeDevice &device)
{
    return [&device](RendererOptions options) -> Result<std::unique_ptr<Renderer>> {
        options.backend = Backend::Cpu;
        Result<std::unique_ptr<Renderer>> cpu = makeRenderer(options);
        if (!cpu)
            return cpu;
        return std::unique_ptr<Renderer>(std::make_unique<FakeDeviceRenderer>(device, std::move(*cpu)));
    };
}

} // namespace suffuse
