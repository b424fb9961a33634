#pragma once

#include "app/canvas/underlay.h"

#include <QOpenGLBuffer>
#include <QOpenGLFunctions>
#include <QOpenGLShaderProgram>

#include <memory>

namespace suffuse {

/// Draws an underlay over what is in the frame buffer, by a texture of its own. The context must be current in every
/// call.
class UnderlayTexture : protected QOpenGLFunctions {
public:
    void draw(const ShownUnderlay &shown, const View &view);
    /// Gives back all that it holds of the context.
    void release();

private:
    bool prepare();
    void upload(const UnderlayImagePtr &image);
    int putCorners(const ShownUnderlay &shown, const View &view);

    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QOpenGLBuffer m_corners;
    GLuint m_texture = 0;
    UnderlayImagePtr m_image; ///< the picture that the texture has
};

} // namespace suffuse
