#include "app/canvas/presenters/presenter.h"
#include "app/canvas/presenters/textured_quad.h"
#include "app/canvas/presenters/underlay_texture.h"
#include "app/canvas/view_transform.h"

#include <QOpenGLBuffer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLWidget>
#include <QPainter>
#include <QSurfaceFormat>

#include <array>
#include <memory>

namespace suffuse {

namespace {

// The headers of OpenGL ES, which Qt may have been built for, do not define this.
constexpr GLenum unpackRowLength = 0x0CF2;

// The bytes of a pixel are blue, green, red, alpha. The texture takes them in this order from memory and from a device,
// so the shader swaps them.
constexpr const char *fragmentShader = R"(
uniform sampler2D picture;
varying highp vec2 texel;
void main()
{
    gl_FragColor = vec4(texture2D(picture, texel).bgr, 1.0);
}
)";

/// Keeps the frame in a texture, and draws it as one quad. Only what is dirty is sent to the texture. A frame on a
/// device is copied there; where that device does not draw this context, frames are asked for in memory.
class OpenGlPresenter : public QOpenGLWidget, public Presenter, protected QOpenGLFunctions {
public:
    OpenGlPresenter(CanvasContent &content, QWidget *parent) : QOpenGLWidget(parent), m_content(content)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        QSurfaceFormat format = QSurfaceFormat::defaultFormat();
        // Samples smooth the lines that QPainter draws; the pixels of the picture are exact without them.
        format.setSamples(4);
        setFormat(format);
    }

    ~OpenGlPresenter() override
    {
        if (context()) // The context ends after the members of this object do.
            disconnect(context(), nullptr, this, nullptr);
        release();
    }

    QWidget *widget() override { return this; }
    QString name() const override { return QStringLiteral("OpenGL"); }
    void updateArea(const QRegion &) override { update(); }

protected:
    void initializeGL() override
    {
        initializeOpenGLFunctions();
        // Qt makes another context when a dock is made to float or the window moves to another screen.
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
        m_program = std::make_unique<QOpenGLShaderProgram>();
        m_program->addShaderFromSourceCode(QOpenGLShader::Vertex, vertexShader);
        m_program->addShaderFromSourceCode(QOpenGLShader::Fragment, fragmentShader);
        m_program->bindAttributeLocation("corner", 0);
        if (!m_program->link())
            qWarning("OpenGL shader: %s", qPrintable(m_program->log()));
        m_corners.create();
        m_corners.setUsagePattern(QOpenGLBuffer::DynamicDraw);
        glGenTextures(1, &m_texture);
        glBindTexture(GL_TEXTURE_2D, m_texture);
        // The texture has one level, and would be incomplete with a filter that uses more.
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        m_textureWidth = m_textureHeight = 0;
        if (!m_refused)
            m_content.setDeviceFramesWanted(true, {});
    }

    void paintGL() override
    {
        m_content.withFrame([this](ShownFrame &frame) {
            const bool uploaded = upload(frame);
            const QColor background = m_content.backgroundColour();
            glDisable(GL_BLEND);
            glDisable(GL_SCISSOR_TEST);
            glClearColor(float(background.redF()), float(background.greenF()), float(background.blueF()), 1);
            glClear(GL_COLOR_BUFFER_BIT);
            if (uploaded && isFrameUseful(frame, m_content.shownView()))
                drawQuad(frame);
        });
        if (const std::optional<ShownUnderlay> underlay = m_content.underlay())
            m_underlay.draw(*underlay, m_content.shownView());
        else
            m_underlay.release();
        QPainter painter(this);
        const double toDevice = 1 / devicePixelRatioF();
        painter.scale(toDevice, toDevice);
        m_content.paintAround(painter);
        m_content.paintOverlay(painter);
    }

private:
    /// Sends the frame to the texture. Returns false where the texture does not show the frame afterwards.
    bool upload(ShownFrame &frame)
    {
        const int width = frame.width(), height = frame.height();
        if (width <= 0 || height <= 0)
            return false;
        if (!frame.device)
            m_link.reset();
        glBindTexture(GL_TEXTURE_2D, m_texture);
        if (width != m_textureWidth || height != m_textureHeight) {
            m_link.reset(); // The link would keep the pixels from before.
            glTexImage2D(GL_TEXTURE_2D, 0, rgba8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            m_textureWidth = width;
            m_textureHeight = height;
            frame.dirty = {PixelRect{0, 0, width, height}};
        }
        if (frame.device) {
            if (!copyFromDevice(frame.device, frame.dirty))
                return false;
        } else {
            sendPicture(frame.picture, frame.dirty);
        }
        frame.dirty.clear();
        return true;
    }

    void sendPicture(const Picture8 &picture, const std::vector<PixelRect> &dirty)
    {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glPixelStorei(unpackRowLength, picture.width);
        for (const PixelRect &r : dirty)
            glTexSubImage2D(GL_TEXTURE_2D, 0, r.x, r.y, r.width, r.height, GL_RGBA, GL_UNSIGNED_BYTE,
                            picture.argb.data() + std::size_t(r.y) * picture.width + r.x);
        glPixelStorei(unpackRowLength, 0);
    }

    bool copyFromDevice(const std::shared_ptr<DeviceFrame> &device, const std::vector<PixelRect> &dirty)
    {
        if (m_refused)
            return false; // A frame in memory is under way.
        if (!m_link || m_linked.owner_before(device) || device.owner_before(m_linked)) {
            m_link.reset();
            Result<std::unique_ptr<TextureLink>> link = device->link(m_texture);
            if (!link)
                return refuse(link.error());
            m_link = std::move(*link);
            m_linked = device;
        }
        const Result<void> copied = device->copyTo(*m_link, dirty);
        return copied || refuse(copied.error());
    }

    bool refuse(const QString &why)
    {
        m_refused = true;
        m_link.reset();
        m_content.setDeviceFramesWanted(false, why);
        return false;
    }

    void drawQuad(const ShownFrame &frame)
    {
        const View &view = m_content.shownView();
        const QTransform map = mapBetween(frame.view, view);
        const bool sharp = frame.view == view;
        const double w = frame.width(), h = frame.height();
        std::array<float, 16> corners;
        float *out = corners.data();
        for (const auto &[u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
            const QPointF p = map.map(QPointF(u * w, v * h));
            *out++ = float(2 * p.x() / view.width - 1);
            *out++ = float(1 - 2 * p.y() / view.height);
            *out++ = float(u);
            *out++ = float(v);
        }
        glViewport(0, 0, view.width, view.height);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, m_texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, sharp ? GL_NEAREST : GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, sharp ? GL_NEAREST : GL_LINEAR);
        m_program->bind();
        m_program->setUniformValue("picture", 0);
        m_corners.bind();
        m_corners.allocate(corners.data(), int(sizeof corners));
        m_program->enableAttributeArray(0);
        m_program->setAttributeBuffer(0, GL_FLOAT, 0, 4);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        m_program->disableAttributeArray(0);
        m_corners.release();
        m_program->release();
    }

    void release()
    {
        if (!m_program)
            return;
        makeCurrent();
        m_link.reset();
        glDeleteTextures(1, &m_texture);
        m_texture = 0;
        m_corners.destroy();
        m_underlay.release();
        m_program.reset();
        doneCurrent();
        m_textureWidth = m_textureHeight = 0;
    }

    CanvasContent &m_content;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QOpenGLBuffer m_corners;
    UnderlayTexture m_underlay;
    GLuint m_texture = 0;
    /// Links m_texture with the device of m_linked; it must end before the texture does.
    std::unique_ptr<TextureLink> m_link;
    std::weak_ptr<DeviceFrame> m_linked;
    bool m_refused = false; ///< whether no device draws this context, or the device failed
    int m_textureWidth = 0;
    int m_textureHeight = 0;
};

} // namespace

Presenter *makeOpenGlPresenter(CanvasContent &content, QWidget *parent)
{
    return new OpenGlPresenter(content, parent);
}

} // namespace suffuse
