#include "app/canvas/presenter.h"
#include "app/canvas/view_transform.h"

#include <QOpenGLBuffer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLWidget>
#include <QPainter>
#include <QSurfaceFormat>

#include <array>

namespace suffuse {

namespace {

// Not in the header of OpenGL ES, which Qt may have been built for.
constexpr GLenum bgra = 0x80E1;
constexpr GLenum unpackRowLength = 0x0CF2;

constexpr const char *vertexShader = R"(
attribute highp vec4 corner; // x, y in clip space; u, v in the texture
varying highp vec2 texel;
void main()
{
    texel = corner.zw;
    gl_Position = vec4(corner.xy, 0.0, 1.0);
}
)";

constexpr const char *fragmentShader = R"(
uniform sampler2D picture;
varying highp vec2 texel;
void main()
{
    gl_FragColor = vec4(texture2D(picture, texel).rgb, 1.0);
}
)";

/// Keeps the frame in a texture, of which only what is dirty is sent, and draws it as one quad.
class OpenGlPresenter : public QOpenGLWidget, public Presenter, protected QOpenGLFunctions {
public:
    OpenGlPresenter(CanvasContent &content, QWidget *parent) : QOpenGLWidget(parent), m_content(content)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        QSurfaceFormat format = QSurfaceFormat::defaultFormat();
        format.setSamples(4); // QPainter's lines; the picture's pixels are exact either way
        setFormat(format);
    }

    ~OpenGlPresenter() override
    {
        if (context()) // it ends after this object's members do
            disconnect(context(), nullptr, this, nullptr);
        release();
    }

    QWidget *widget() override { return this; }
    QString name() const override { return QStringLiteral("OpenGL"); }
    void updateArea(const QRect &) override { update(); }

protected:
    void initializeGL() override
    {
        initializeOpenGLFunctions();
        // Floating a dock or moving to another screen makes another context.
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
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        m_textureWidth = m_textureHeight = 0;
    }

    void paintGL() override
    {
        m_content.withFrame([this](ShownFrame &frame) {
            upload(frame);
            const QColor background = m_content.backgroundColour();
            glDisable(GL_BLEND);
            glDisable(GL_SCISSOR_TEST);
            glClearColor(float(background.redF()), float(background.greenF()), float(background.blueF()), 1);
            glClear(GL_COLOR_BUFFER_BIT);
            if (isFrameUseful(frame, m_content.shownView()))
                drawQuad(frame);
        });
        QPainter painter(this);
        const double toDevice = 1 / devicePixelRatioF();
        painter.scale(toDevice, toDevice);
        m_content.paintOverlay(painter);
    }

private:
    void upload(ShownFrame &frame)
    {
        const Picture8 &picture = frame.picture;
        if (picture.argb.empty())
            return;
        glBindTexture(GL_TEXTURE_2D, m_texture);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        if (picture.width != m_textureWidth || picture.height != m_textureHeight) {
            m_textureWidth = picture.width;
            m_textureHeight = picture.height;
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, picture.width, picture.height, 0, bgra, GL_UNSIGNED_BYTE,
                         picture.argb.data());
        } else {
            glPixelStorei(unpackRowLength, picture.width);
            for (const PixelRect &r : frame.dirty)
                glTexSubImage2D(GL_TEXTURE_2D, 0, r.x, r.y, r.width, r.height, bgra, GL_UNSIGNED_BYTE,
                                picture.argb.data() + std::size_t(r.y) * picture.width + r.x);
            glPixelStorei(unpackRowLength, 0);
        }
        frame.dirty.clear();
    }

    void drawQuad(const ShownFrame &frame)
    {
        const View &view = m_content.shownView();
        const QTransform map = mapBetween(frame.view, view);
        const bool sharp = frame.view == view;
        const double w = frame.picture.width, h = frame.picture.height;
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
        glDeleteTextures(1, &m_texture);
        m_texture = 0;
        m_corners.destroy();
        m_program.reset();
        doneCurrent();
        m_textureWidth = m_textureHeight = 0;
    }

    CanvasContent &m_content;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QOpenGLBuffer m_corners;
    GLuint m_texture = 0;
    int m_textureWidth = 0;
    int m_textureHeight = 0;
};

} // namespace

Presenter *makeOpenGlPresenter(CanvasContent &content, QWidget *parent)
{
    return new OpenGlPresenter(content, parent);
}

} // namespace suffuse
