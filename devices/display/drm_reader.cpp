#include "devices/display/drm_reader.hpp"

#include "devices/unique_fd.hpp"

#include <xf86drm.h>
#include <xf86drmMode.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>

#include <fcntl.h>

namespace autostereo::devices {

namespace {

template<auto Free>
struct Freer {
    template<class Object>
    void operator()(Object* object) const {
        Free(object);
    }
};

using Resources = std::unique_ptr<drmModeRes, Freer<drmModeFreeResources>>;
using PlaneResources = std::unique_ptr<drmModePlaneRes, Freer<drmModeFreePlaneResources>>;
using ConnectorInfo = std::unique_ptr<drmModeConnector, Freer<drmModeFreeConnector>>;
using EncoderInfo = std::unique_ptr<drmModeEncoder, Freer<drmModeFreeEncoder>>;
using PlaneInfo = std::unique_ptr<drmModePlane, Freer<drmModeFreePlane>>;
using ObjectProperties =
    std::unique_ptr<drmModeObjectProperties, Freer<drmModeFreeObjectProperties>>;
using PropertyInfo = std::unique_ptr<drmModePropertyRes, Freer<drmModeFreeProperty>>;
using Blob = std::unique_ptr<drmModePropertyBlobRes, Freer<drmModeFreePropertyBlob>>;

void addBlob(int card, DrmProperty& property) {
    if (property.value == 0 || property.value > UINT32_MAX) return;
    const Blob blob(drmModeGetPropertyBlob(card, static_cast<std::uint32_t>(property.value)));
    if (blob == nullptr || blob->data == nullptr) return;
    const auto* first = static_cast<const std::byte*>(blob->data);
    property.blob.assign(first, first + blob->length);
}

DrmProperty describe(int card, drmModePropertyRes& info, std::uint64_t value) {
    DrmProperty property;
    property.name.assign(info.name, ::strnlen(info.name, sizeof info.name));
    property.value = value;
    if (drm_property_type_is(&info, DRM_MODE_PROP_BLOB) != 0) addBlob(card, property);
    const bool isEnum = drm_property_type_is(&info, DRM_MODE_PROP_ENUM) != 0;
    for (int i = 0; isEnum && i < info.count_enums; ++i) // a bit mask's are numbers of bits
        if (info.enums[i].value == value)
            property.word.assign(info.enums[i].name,
                                 ::strnlen(info.enums[i].name, sizeof info.enums[i].name));
    return property;
}

std::vector<DrmProperty> propertiesOf(int card, std::uint32_t object, std::uint32_t type) {
    std::vector<DrmProperty> found;
    const ObjectProperties all(drmModeObjectGetProperties(card, object, type));
    for (std::uint32_t i = 0; all != nullptr && i < all->count_props; ++i)
        if (const PropertyInfo info(drmModeGetProperty(card, all->props[i])); info != nullptr)
            found.push_back(describe(card, *info, all->prop_values[i]));
    return found;
}

/// Properties of the primary plane that shows on this CRTC, else none.
std::vector<DrmProperty> primaryPlane(int card, std::uint32_t crtc) {
    const PlaneResources planes(drmModeGetPlaneResources(card));
    for (std::uint32_t i = 0; planes != nullptr && i < planes->count_planes; ++i) {
        const PlaneInfo plane(drmModeGetPlane(card, planes->planes[i]));
        if (plane == nullptr || plane->crtc_id != crtc) continue;
        auto properties = propertiesOf(card, plane->plane_id, DRM_MODE_OBJECT_PLANE);
        const auto type = std::ranges::find(properties, "type", &DrmProperty::name);
        if (type != properties.end() && type->word == "Primary") return properties;
    }
    return {};
}

/// The CRTC that feeds a connector; 0: none. Old drivers tell it through the encoder only.
std::uint32_t crtcOf(int card, const drmModeConnector& connector,
                     const std::vector<DrmProperty>& properties) {
    const auto id = std::ranges::find(properties, "CRTC_ID", &DrmProperty::name);
    if (id != properties.end()) return static_cast<std::uint32_t>(id->value);
    const EncoderInfo encoder(drmModeGetEncoder(card, connector.encoder_id));
    return encoder == nullptr ? 0 : encoder->crtc_id;
}

DrmPipe pipeOf(int card, const drmModeConnector& connector) {
    DrmPipe pipe;
    const char* type = drmModeGetConnectorTypeName(connector.connector_type);
    pipe.connector = std::string(type != nullptr ? type : "Unknown") + "-" +
                     std::to_string(connector.connector_type_id);
    pipe.connectorProperties =
        propertiesOf(card, connector.connector_id, DRM_MODE_OBJECT_CONNECTOR);
    const std::uint32_t crtc = crtcOf(card, connector, pipe.connectorProperties);
    if (crtc == 0) return pipe; // dark
    pipe.crtcProperties = propertiesOf(card, crtc, DRM_MODE_OBJECT_CRTC);
    pipe.planeProperties = primaryPlane(card, crtc);
    return pipe;
}

void readCard(const std::filesystem::path& file, DrmReading& reading) {
    const UniqueFd card(::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!card) {
        reading.notes.push_back(file.string() + ": cannot open it: " + errnoText() +
                                " (its links' state is unknown; group video may read it)");
        return;
    }
    drmDropMaster(card.get());
    drmSetClientCap(card.get(), DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1);
    drmSetClientCap(card.get(), DRM_CLIENT_CAP_ATOMIC, 1);
    const Resources resources(drmModeGetResources(card.get()));
    if (resources == nullptr) {
        reading.notes.push_back(file.string() + ": drives no monitors: " + errnoText());
        return;
    }
    for (int i = 0; i < resources->count_connectors; ++i) {
        // The "current" call does not probe: probing can blank a running display for a while.
        const ConnectorInfo connector(
            drmModeGetConnectorCurrent(card.get(), resources->connectors[i]));
        if (connector == nullptr || connector->connection != DRM_MODE_CONNECTED) continue;
        reading.pipes.push_back(pipeOf(card.get(), *connector));
        reading.pipes.back().card = file.filename();
    }
}

} // namespace

DrmReading readDrm(const std::filesystem::path& folder) {
    DrmReading reading;
    std::error_code error;
    std::vector<std::filesystem::path> cards;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
        if (entry->path().filename().string().starts_with("card")) cards.push_back(entry->path());
    std::ranges::sort(cards);
    for (const auto& card : cards)
        readCard(card, reading);
    return reading;
}

} // namespace autostereo::devices
