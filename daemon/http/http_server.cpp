#include "daemon/http/http_server.hpp"

#include "daemon/http/http_listener.hpp"
#include "daemon/http/http_site.hpp"

namespace autostereo::daemon {

namespace {

HttpToken tokenOf(const config::HttpParams& params) {
    return params.tokenFile.empty() ? HttpToken() : HttpToken(params.tokenFile);
}

} // namespace

HttpServer::HttpServer(const config::HttpParams& params, const HttpLimits& limits)
    : listen_(params.listen.value()),
      site_(std::make_unique<HttpSite>(listen_.loopback, tokenOf(params), box_, refusals_, limits)),
      listener_(std::make_unique<HttpListener>(
          listen_, [this](int socket) { site_->serve(socket); }, refusals_)) {}

HttpServer::~HttpServer() { box_.close(); }

std::uint16_t HttpServer::port() const { return listener_->port(); }

std::string HttpServer::address() const {
    const bool six = listen_.address.find(':') != std::string::npos;
    return "http://" + (six ? '[' + listen_.address + ']' : listen_.address) + ':' +
           std::to_string(port()) + '/';
}

} // namespace autostereo::daemon
