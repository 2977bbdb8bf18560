/* global document, location, URL, matchMedia */
/** The API's documentation: Swagger UI from our own server, whose requests carry the CSRF token of whoever is signed in. */
import 'swagger-ui-dist/swagger-ui.css'

import SwaggerUI from 'swagger-ui-dist/swagger-ui-es-bundle.js'

function csrfToken() {
  return /(?:^|; )soundlist_csrf=([^;]*)/.exec(document.cookie)?.[1]
}

const dark = matchMedia('(prefers-color-scheme: dark)')
const followScheme = () => document.documentElement.classList.toggle('dark-mode', dark.matches)
dark.addEventListener('change', followScheme)
followScheme()

SwaggerUI({
  dom_id: '#api',
  url: '/v1/openapi.json',
  docExpansion: 'none', // rendering every endpoint at once takes seconds
  defaultModelsExpandDepth: -1, // each endpoint shows its own
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
