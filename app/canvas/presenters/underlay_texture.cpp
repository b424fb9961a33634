#include "app/canvas/presenters/underlay_texture.h"

#include "app/canvas/presenters/textured_quad.h"
#include "app/canvas/view_transform.h"

#include <vector>

namespace suffuse {

namespace {

// Where the underlay is clear, what is below is multiplied by white, or screened with black. The bytes of a pixel are
// blue, green, red, alpha, premultiplied.
constexpr const char *underlayShader = R"(
uniform sampler2D picture;
uniform highp float opacity;
uniform highp float ground;
varying highp vec2 texel;
void main()
{
    highp vec4 colour = opacity * texture2D(picture, texel).bgra;
    gl_FragColor = vec4(ground * (1.0 - colour.a) + colour.rgb, 1.0);
}
)";

} // namespace

bool UnderlayTexture::prepare()
{
    if (m_program)
        return m_program->isLinked();
    initializeOpenGLFunctions();
    m_program = std::make_unique<QOpenGLShaderProgram>();
    m_program->addShaderFromSourceCode(QOpenGLShader::Vertex, vertexShader);
    m_program->addShaderFromSourceCode(QOpenGLShader::Fragment, underlayShader);
    m_program->bindAttributeLocation("corner", 0);
    if (!m_program->link())
        qWarning("OpenGL shader: %s", qPrintable(m_program->log()));
    m_corners.create();
    m_corners.setUsagePattern(QOpenGLBuffer::DynamicDraw);
    return m_program->isLinked();
}

void UnderlayTexture::upload(const UnderlayImagePtr &image)
{
    if (m_texture == 0)
        glGenTextures(1, &m_texture);
    glBindTexture(GL_TEXTURE_2D, m_texture);
    if (image == m_image)
        return;
    m_image = image;
    GLint largest = 0, level = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (const QImage &picture : image->levels)
        if (std::max(picture.width(), picture.height()) <= largest)
            glTexImage2D(GL_TEXTURE_2D, level++, rgba8, picture.width(), picture.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         picture.constBits());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// Sets the corners of the part of the underlay that the view shows, as a fan. At deep zoom the underlay's own corners
/// lie beyond what floats can tell apart.
int UnderlayTexture::putCorners(const ShownUnderlay &shown, const View &view)
{
    const QPolygonF polygon = clippedCorners(view, shown.area, Rect::of(0, 0, view.width, view.height).grown(1));
    const UnderlayMap map(shown, view);
    std::vector<float> corners;
    for (const QPointF &p : polygon) {
        const Point share = map({p.x(), p.y()});
        corners.insert(corners.end(), {float(2 * p.x() / view.width - 1), float(1 - 2 * p.y() / view.height),
                                       float(share.x), float(share.y)});
    }
    m_corners.bind();
    m_corners.allocate(corners.data(), int(corners.size() * sizeof(float)));
    return int(polygon.size());
}

void UnderlayTexture::draw(const ShownUnderlay &shown, const View &view)
{
    if (!prepare())
        return;
    glViewport(0, 0, view.width, view.height);
    glActiveTexture(GL_TEXTURE0);
    upload(shown.image);
    glEnable(GL_BLEND);
    glBlendFunc(shown.brightens ? GL_ONE : GL_DST_COLOR, shown.brightens ? GL_ONE_MINUS_SRC_COLOR : GL_ZERO);
    m_program->bind();
    m_program->setUniformValue("picture", 0);
    m_program->setUniformValue("opacity", float(shown.opacity));
    m_program->setUniformValue("ground", shown.brightens ? 0.0f : 1.0f);
    if (const int count = putCorners(shown, view); count > 2) {
        m_program->enableAttributeArray(0);
        m_program->setAttributeBuffer(0, GL_FLOAT, 0, 4);
        glDrawArrays(GL_TRIANGLE_FAN, 0, count);
        m_program->disableAttributeArray(0);
    }
    m_corners.release();
    m_program->release();
    glDisable(GL_BLEND);
}

void UnderlayTexture::release()
{
    if (m_texture != 0)
        glDeleteTextures(1, &m_texture);
    m_texture = 0;
    m_corners.destroy();
    m_program.reset();
    m_image.reset();
}

} // namespace suffuse
