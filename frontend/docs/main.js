/* global document, location, URL */
/** The API's documentation: Swagger UI from our own server, whose requests carry the CSRF token of whoever is signed in. */
import 'swagger-ui-dist/swagger-ui.css'

import SwaggerUI from 'swagger-ui-dist/swagger-ui-es-bundle.js'

function csrfToken() {
  return /(?:^|; )soundlist_csrf=([^;]*)/.exec(document.cookie)?.[1]
}

SwaggerUI({
  dom_id: '#api',
  url: '/v1/openapi.json',
  deepLinking: true,
  validatorUrl: null,
  requestInterceptor: (request) => {
    const token = csrfToken()
    if (token !== undefined && new URL(request.url, location.href).origin === location.origin) {
      request.headers['X-CSRF-Token'] = token
    }
    return request
  },
})
