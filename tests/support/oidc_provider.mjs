// npm's oidc-provider on a free port, with one client and one account, for the tests of sign-in by a provider.
// Started as: node oidc_provider.mjs REDIRECT_URI EMAIL; prints the issuer on its first line.
import { createServer } from 'node:http'
import { createRequire } from 'node:module'
import { pathToFileURL } from 'node:url'

const [redirectUri, email] = process.argv.slice(2)
const installed = createRequire(new URL('../../frontend/package.json', import.meta.url))
const { Provider } = await import(pathToFileURL(installed.resolve('oidc-provider')).href)

const server = createServer()
server.listen(0, '127.0.0.1', () => {
  const issuer = `http://127.0.0.1:${server.address().port}`
  const provider = new Provider(issuer, {
    clients: [{ client_id: 'soundlist', client_secret: 'a secret: of the client/studio', redirect_uris: [redirectUri] }],
    claims: { openid: ['sub'], email: ['email', 'email_verified'], profile: ['name'] },
    conformIdTokenClaims: false, // claims of the scopes are in the ID token
    pkce: { required: () => true },
    findAccount: (_ctx, id) => ({
      accountId: id,
      claims: () => ({ sub: id, email, email_verified: true, name: 'Ada' }),
    }),
  })
  server.on('request', provider.callback())
  console.log(issuer)
})
