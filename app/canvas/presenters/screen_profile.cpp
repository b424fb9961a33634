#include "app/canvas/presenters/screen_profile.h"

#include "render/image_io/colour_conversion.h"

#include <QGuiApplication>
#include <QScreen>

#include <xcb/xcb.h>

#include <cstdlib>
#include <memory>

namespace suffuse {

namespace {

template <class Reply>
using Owned = std::unique_ptr<Reply, void (*)(void *)>;

xcb_atom_t atomNamed(xcb_connection_t *x, const QByteArray &name)
{
    const auto asked = xcb_intern_atom(x, true, uint16_t(name.size()), name.constData());
    const Owned<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(x, asked, nullptr), std::free);
    return reply ? reply->atom : xcb_atom_t(XCB_ATOM_NONE);
}

} // namespace

QByteArray systemProfileOf(const QScreen *screen)
{
    const auto *x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
    xcb_connection_t *x = x11 ? x11->connection() : nullptr;
    if (!x)
        return {};
    const auto number = std::max<qsizetype>(0, QGuiApplication::screens().indexOf(screen));
    const xcb_atom_t profile = atomNamed(x, number > 0 ? "_ICC_PROFILE_" + QByteArray::number(number) : "_ICC_PROFILE");
    if (profile == XCB_ATOM_NONE)
        return {};
    const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(x)).data->root;
    const auto asked =
        xcb_get_property(x, false, root, profile, XCB_GET_PROPERTY_TYPE_ANY, 0, uint32_t(largestProfile / 4));
    const Owned<xcb_get_property_reply_t> reply(xcb_get_property_reply(x, asked, nullptr), std::free);
    if (!reply || reply->format != 8)
        return {};
    return {static_cast<const char *>(xcb_get_property_value(reply.get())), xcb_get_property_value_length(reply.get())};
}

} // namespace suffuse
