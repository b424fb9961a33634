// Objects of these types own memory of a device. The header is C++20 and knows no Qt.
#pragma once

#include "render/cuda/device/device.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace suffuse::cuda {

enum class Where { Device, PinnedHost };

/// This array grows by doubling. When it grows, its content is lost.
template <class T, Where where>
class Buffer {
public:
    explicit Buffer(Device &device) : m_device(&device) {}
    Buffer(const Buffer &) = delete;
    Buffer &operator=(const Buffer &) = delete;
    ~Buffer() { release(); }

    /// Makes room for `count`. `grown`, if not null, becomes true if it is new memory.
    Fault reserve(std::size_t count, bool *grown = nullptr)
    {
        if (count <= m_room)
            return {};
        const std::size_t twice = std::max(count, 2 * m_room);
        release();
        Fault fault = allocate(twice);
        if (fault.kind == Fault::OutOfMemory && twice > count)
            fault = allocate(count);
        if (!fault && grown)
            *grown = true;
        return fault;
    }
    void release()
    {
        if (!m_data)
            return;
        if constexpr (where == Where::Device)
            m_device->release(m_data);
        else
            m_device->releaseHost(m_data);
        m_data = nullptr;
        m_room = 0;
    }
    T *data() const { return m_data; }

private:
    Fault allocate(std::size_t count)
    {
        void *memory = nullptr;
        const std::size_t bytes = count * sizeof(T);
        Fault fault =
            where == Where::Device ? m_device->allocate(bytes, &memory) : m_device->allocateHost(bytes, &memory);
        if (!fault)
            m_data = static_cast<T *>(memory), m_room = count;
        return fault;
    }

    Device *m_device;
    T *m_data = nullptr;
    std::size_t m_room = 0;
};

template <class T>
using DeviceArray = Buffer<T, Where::Device>;
template <class T>
using PinnedArray = Buffer<T, Where::PinnedHost>;

/// Stands for the indices [first, second).
using IndexRange = std::pair<std::size_t, std::size_t>;

/// The host writes this array and the device reads it. Only what was touched is uploaded.
template <class T>
class Mirror {
public:
    explicit Mirror(Device &device) : m_device(device), m_copy(device) {}

    std::vector<T> &host() { return m_host; } ///< its length must be changed by `resize`
    const std::vector<T> &host() const { return m_host; }
    const T *device() const { return m_copy.data(); }

    /// Makes the elements [at, at + count) anew, the i-th of them by make(i). Returns those whose bytes changed, to be
    /// given to `touch`. Several threads may do so for elements of their own.
    template <class Make>
    IndexRange set(std::size_t at, std::size_t count, Make make)
    {
        IndexRange changed{at + count, at};
        for (std::size_t i = 0; i < count; ++i) {
            const T value = make(i);
            if (std::memcmp(&m_host[at + i], &value, sizeof(T)) == 0)
                continue;
            m_host[at + i] = value;
            changed.first = std::min(changed.first, at + i);
            changed.second = at + i + 1;
        }
        return changed;
    }
    /// Notes that these elements were written.
    void touch(const IndexRange &range)
    {
        if (range.first < range.second)
            m_touched.push_back(range);
    }
    /// Changes the length. What is added is zero, and touched.
    void resize(std::size_t count)
    {
        touch({m_host.size(), count});
        m_host.resize(count);
    }
    Fault upload()
    {
        bool grown = false;
        if (Fault fault = m_copy.reserve(m_host.size(), &grown))
            return fault;
        if (grown)
            m_touched = {IndexRange{0, m_host.size()}};
        std::sort(m_touched.begin(), m_touched.end());
        for (std::size_t i = 0; i < m_touched.size();) {
            auto [begin, end] = m_touched[i++];
            for (; i < m_touched.size() && m_touched[i].first <= end + near; ++i)
                end = std::max(end, m_touched[i].second);
            end = std::min(end, m_host.size());
            if (begin >= end)
                continue;
            if (Fault fault = m_device.upload(m_copy.data() + begin, m_host.data() + begin, (end - begin) * sizeof(T)))
                return fault;
        }
        m_touched.clear();
        return {};
    }

private:
    /// Ranges that lie nearer than this are uploaded together, since a call costs as much as so many elements.
    static constexpr std::size_t near = 16384 / sizeof(T);

    Device &m_device;
    std::vector<T> m_host;
    DeviceArray<T> m_copy;
    std::vector<IndexRange> m_touched;
};

} // namespace suffuse::cuda
